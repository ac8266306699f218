// DXF as a sequence of group codes and values, and the curves that entities stand for
// (Autodesk, DXF Reference, "ENTITIES Section").
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/domain/bspline.h"
#include "io/domain/curves.h"
#include "io/mesh_text.h"

namespace lpq {

struct DxfGroup {
  std::int64_t code = 0;
  std::string_view value;
  std::int64_t line = 0, byte = 0;  // of the value
};

/// Pairs of lines: a group code and its value.
class DxfGroups {
 public:
  explicit DxfGroups(std::string_view text) : lines_(text) {}
  /// False at the end of the text, and where a group code is not a number.
  bool next(DxfGroup& group);
  bool is_malformed() const { return malformed_; }
  Error error(std::string message) const { return lines_.error(std::move(message)); }

 private:
  LineReader lines_;
  bool malformed_ = false;
};

/// An entity, and for a POLYLINE its VERTEX entities.
struct DxfEntity {
  std::string_view type, layer;
  std::int64_t line = 0, byte = 0;
  std::vector<DxfGroup> groups;
};

struct DxfCurve {
  CurvePath path;
  std::unique_ptr<BSpline> spline;  // instead of the path
  bool closed = false;
  bool has_height = false;    // a z coordinate that is not 0 was ignored
  bool interpolated = false;  // a spline through fit points only
};

bool is_dxf_curve(std::string_view type);

/// The curve of an entity; nothing for one that draws nothing here (a polygon mesh, a polyline of
/// one vertex). `vertices` are those of a POLYLINE. Errors: parse_error with the place.
Result<std::optional<DxfCurve>> make_dxf_curve(const DxfEntity& entity,
                                               const std::vector<DxfEntity>& vertices);

}  // namespace lpq

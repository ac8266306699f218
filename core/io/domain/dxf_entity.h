// The curves that DXF entities stand for (Autodesk, DXF Reference, "ENTITIES Section").
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "io/domain/bspline.h"
#include "io/domain/curves.h"
#include "io/domain/dxf_groups.h"

namespace lpq {

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

// DXF as a sequence of group codes and values, and the fields of one entity
// (Autodesk, DXF Reference, "ENTITIES Section").
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec.h"
#include "io/text_lines.h"

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

/// An entity, a layer or the head of a block: its type and the groups that follow.
struct DxfEntity {
  std::string_view type, layer;
  std::int64_t line = 0, byte = 0;
  std::vector<DxfGroup> groups;
};

/// Looks groups up by their code. The first thing that is wrong becomes the error, a parse_error
/// with its place; what was asked for is 0 then.
class DxfFields {
 public:
  /// The entity must stay where it is.
  explicit DxfFields(const DxfEntity& entity) : entity_(entity) {}

  const DxfEntity& entity() const { return entity_; }
  bool failed() const { return failed_; }
  const Error& error() const { return error_; }

  void fail(const Error& error);
  /// "The ARC `clause`.", at the entity.
  void fail(const std::string& clause);

  double number(const DxfGroup& group);
  double number(std::int64_t code);
  double optional_number(std::int64_t code, double otherwise);
  Vec2 point(std::int64_t x_code) { return {number(x_code), number(x_code + 10)}; }
  std::string_view text(std::int64_t code) const;
  unsigned flags();
  /// Entities in their own plane: only the drawing's plane itself, seen from above or from below,
  /// where x points the other way (DXF Reference, "Arbitrary Axis Algorithm").
  bool is_mirrored();

 private:
  const DxfGroup* find(std::int64_t code) const;

  const DxfEntity& entity_;
  bool failed_ = false;
  Error error_;
};

}  // namespace lpq

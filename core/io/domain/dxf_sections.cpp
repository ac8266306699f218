// See dxf_sections.h.
#include "io/domain/dxf_sections.h"

#include <algorithm>
#include <cmath>

#include "io/plain_text.h"

namespace lpq {
namespace {

/// A count of rows or columns: 16 bits in DXF, and 0 as good as 1.
Index copies(double value) {
  constexpr double most = 32767;
  return value >= 1 ? static_cast<Index>(std::min(value, most)) : 1;
}

/// DXF Reference, "INSERT": the block is scaled, then turned, then put in its place; rows and
/// columns are turned with it, but not scaled.
Result<DxfInsert> make_insert(const DxfEntity& entity) {
  DxfFields fields(entity);
  const Vec2 at = fields.point(10);
  const double sx = fields.optional_number(41, 1), sy = fields.optional_number(42, 1);
  const double angle = fields.optional_number(50, 0);
  constexpr double largest_angle = 1e5;
  if (sx == 0 || sy == 0) fields.fail("has a scale of 0");
  if (!(std::abs(angle) < largest_angle)) fields.fail("has an angle that is out of range");
  DxfInsert insert;
  insert.block = fields.text(2);
  insert.columns = copies(fields.optional_number(70, 1));
  insert.rows = copies(fields.optional_number(71, 1));
  const double dx = fields.optional_number(44, 0), dy = fields.optional_number(45, 0);
  insert.has_height = fields.optional_number(30, 0) != 0;
  const bool mirrored = fields.is_mirrored();
  if (fields.failed()) return fields.error();
  const Direction t = direction_of_degrees(angle);
  const Affine plane{mirrored ? -1.0 : 1.0, 0, 0, 1, 0, 0};
  insert.map = plane * Affine{sx * t.cos, sx * t.sin, -sy * t.sin, sy * t.cos, at.x, at.y};
  insert.column_step = plane.direction(dx * Vec2{t.cos, t.sin});
  insert.row_step = plane.direction(dy * Vec2{-t.sin, t.cos});
  return insert;
}

class SectionReader {
 public:
  explicit SectionReader(std::string_view text) : groups_(text) {}

  Result<DxfSections> read() {
    while (find_section()) {
      if (section_ == "TABLES") read_tables();
      if (section_ == "BLOCKS") read_blocks();
      if (section_ != "ENTITIES") continue;
      while (!at_end_of_section() && !sections_.drawing.error) read_item(&sections_.drawing);
      break;
    }
    if (sections_.drawing.error) return *sections_.drawing.error;
    if (failed_) return error_;
    return std::move(sections_);
  }

 private:
  bool fail(std::string message) {
    if (!failed_) error_ = groups_.error(std::move(message));
    failed_ = true;
    return false;
  }
  bool next() {
    if (groups_.next(group_)) return true;
    return fail(groups_.is_malformed()
                    ? "A group code (a whole number) was expected; this is not ASCII DXF."
                    : "The file ends before its ENTITIES section does.");
  }
  bool at_end_of_section() const {
    return failed_ || group_.value == "ENDSEC" || group_.value == "EOF";
  }

  /// Goes to the first entity of the next section.
  bool find_section() {
    bool in_header = false;
    while (!failed_ && next()) {
      if (in_header && group_.code == 2) {
        section_ = group_.value;
        bool is_code_page = false;
        while (next() && group_.code != 0) {
          if (is_code_page) sections_.code_page = group_.value;
          is_code_page = group_.code == 9 && group_.value == "$DWGCODEPAGE";
        }
        return !failed_;
      }
      in_header = group_.code == 0 && group_.value == "SECTION";
      if (group_.code == 0 && group_.value == "EOF") return fail("There is no ENTITIES section.");
    }
    return false;
  }

  /// The entity that starts at the current group; then that group is the start of the next one.
  DxfEntity take_entity() {
    DxfEntity entity{group_.value, {}, group_.line, group_.byte, {}};
    while (next() && group_.code != 0) {
      if (group_.code == 8) entity.layer = group_.value;
      entity.groups.push_back(group_);
    }
    return entity;
  }

  void read_tables();
  void read_blocks();
  void read_item(DxfBlock* block);

  DxfGroups groups_;
  DxfGroup group_;
  std::string_view section_;
  DxfSections sections_;
  bool failed_ = false;
  Error error_;
};

void SectionReader::read_tables() {
  constexpr unsigned frozen = 1;
  while (!at_end_of_section()) {
    const DxfEntity entry = take_entity();
    if (entry.type != "LAYER") continue;
    DxfFields fields(entry);
    sections_.layers[dxf_key(fields.text(2))] = {(fields.flags() & frozen) != 0,
                                                 fields.optional_number(62, 0) < 0};
  }
}

void SectionReader::read_blocks() {
  constexpr unsigned in_another_file = 4 | 8;
  DxfBlock* block = nullptr;
  while (!at_end_of_section()) {
    if (group_.value != "BLOCK") {
      read_item(block);
      continue;
    }
    const DxfEntity head = take_entity();
    DxfFields fields(head);
    const std::string_view name = fields.text(2);
    const auto [entry, is_new] = sections_.blocks.try_emplace(dxf_key(name));
    block = is_new ? &entry->second : nullptr;
    if (!is_new) continue;
    block->name = name;
    block->base = {fields.optional_number(10, 0), fields.optional_number(20, 0)};
    block->external = (fields.flags() & in_another_file) != 0;
    if (fields.failed()) block->error = fields.error();
  }
}

/// Into the block, if there is one.
void SectionReader::read_item(DxfBlock* block) {
  const DxfEntity entity = take_entity();
  std::vector<DxfEntity> vertices;
  while (!failed_ &&
         (group_.value == "VERTEX" || group_.value == "ATTRIB" || group_.value == "SEQEND")) {
    DxfEntity vertex = take_entity();
    if (entity.type == "POLYLINE" && vertex.type == "VERTEX") vertices.push_back(std::move(vertex));
  }
  if (failed_ || block == nullptr || entity.type == "ENDBLK") return;
  DxfItem item{entity.type, entity.layer, entity.line, entity.byte, false, false, {}, {}};
  const DxfFields fields(entity);
  item.on_paper = fields.text(67) == "1";
  item.invisible = fields.text(60) == "1";
  const auto take = [&](auto made, auto& place) {
    if (made) {
      place = *std::move(made);
    } else if (!block->error) {
      block->error = made.error();
    }
  };
  if (!item.invisible && is_dxf_curve(entity.type))
    take(make_dxf_curve(entity, vertices), item.curve);
  if (!item.invisible && entity.type == "INSERT") take(make_insert(entity), item.insert);
  block->items.push_back(std::move(item));
}

}  // namespace

std::string dxf_key(std::string_view name) { return lower_case(std::string(name)); }

Result<DxfSections> read_dxf_sections(std::string_view text) { return SectionReader(text).read(); }

}  // namespace lpq

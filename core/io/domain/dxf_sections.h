// What a DXF file holds: its layers, its blocks and its entities, each made a curve already
// (Autodesk, DXF Reference, "TABLES Section", "BLOCKS Section", "ENTITIES Section").
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/domain/dxf_entity.h"

namespace lpq {

struct DxfLayer {
  bool frozen = false, off = false;
};

/// Copies of a block in rows and columns.
struct DxfInsert {
  std::string_view block;  // its name
  Affine map;              // of the first copy; the block's base point goes to (0, 0) before it
  Index columns = 1, rows = 1;
  Vec2 column_step, row_step;
  bool has_height = false;  // a z coordinate that is not 0 was ignored
};

/// One entity of a drawing or of a block; without a curve and an insert, something that draws none.
struct DxfItem {
  std::string_view type, layer;
  std::int64_t line = 0, byte = 0;
  bool on_paper = false;
  bool invisible = false;
  std::optional<DxfCurve> curve;
  std::optional<DxfInsert> insert;
};

struct DxfBlock {
  std::string_view name;
  Vec2 base;
  bool external = false;  // another file holds what it draws
  std::vector<DxfItem> items;
  Problem error;  // the first entity that is wrong: nobody minds until it is used
};

struct DxfSections {
  std::map<std::string, DxfLayer> layers;  // by names in small letters, as CAD compares them
  std::map<std::string, DxfBlock> blocks;
  DxfBlock drawing;            // the ENTITIES section
  std::string_view code_page;  // $DWGCODEPAGE of the HEADER section
};

/// The key of a layer or block: its name with A-Z as a-z.
std::string dxf_key(std::string_view name);

/// Views into the text, which must stay. Errors: parse_error with line and byte; of entities in
/// blocks see DxfBlock.
Result<DxfSections> read_dxf_sections(std::string_view text);

}  // namespace lpq

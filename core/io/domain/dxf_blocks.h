// The blocks of a DXF drawing put where its INSERT entities place them.
#pragma once

#include <vector>

#include "io/domain/drawing.h"
#include "io/domain/dxf_names.h"
#include "io/domain/dxf_sections.h"

namespace lpq {

/// A curve of the drawing, or a copy of one of a block.
struct DxfPiece {
  const DxfCurve* curve = nullptr;  // in the sections
  bool moved = false;               // by the map; else it stays as it is written
  Affine map;
  Index source = none;  // in the drawing
  bool on_paper = false;
};

struct DxfPieces {
  std::vector<DxfPiece> pieces;
  Counter left_out;            // entities that draw no outline here
  Counter hidden;              // invisible ones, and those on layers that are frozen or off
  Index heights = 0;           // entities at a z other than 0
  Index interpolated = 0;      // splines given by fit points alone
  bool foreign_names = false;  // of letters outside ASCII that are not written in UTF-8
};

/// Blocks within blocks, at most.
inline constexpr int deepest_block = 32;
/// Entities of all copies of blocks together: a few INSERTs could ask for any number of them.
inline constexpr Index most_copies = 1 << 18;

/// What the drawing shows, in the order of the file, with a source for every piece. Entities of a
/// block on layer "0" are on the layer of its INSERT. Errors: parse_error (an entity of a block
/// that is used; a block that contains itself), too_large (most_copies, deepest_block), with place.
Result<DxfPieces> place_dxf_blocks(const DxfSections& sections, DxfLetters letters,
                                   Drawing& drawing);

}  // namespace lpq

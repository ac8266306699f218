// The elements of an SVG document, walked through in the order in which they are drawn; <use>
// draws its element where it stands (W3C, SVG 1.1, chapter 5.6).
#pragma once

#include <string_view>
#include <vector>

#include "io/domain/drawing.h"
#include "io/domain/painted.h"
#include "io/domain/svg_path.h"

namespace lpq {

/// A subpath in the drawing's coordinates, y upwards.
struct SvgOutline {
  Subpath path;
  FillRule fill = FillRule::nonzero;
  Index source = none;  // of the drawing
};

struct SvgOutlines {
  std::vector<SvgOutline> outlines;
  Counter left_out;        // elements that draw what is not read
  Counter not_applied;     // what would hide or move parts of what is drawn
  Index unread_rules = 0;  // of style sheets, about what is drawn and filled (svg_style.h)
};

/// <use> of elements with <use>, at most.
inline constexpr std::size_t deepest_use = 32;
/// Bytes read again for <use>, or as many as the text has: few of them could ask for any number.
inline constexpr std::size_t most_copied_bytes = 1 << 23;

/// Errors: parse_error, with line and byte; also an element that draws itself by <use>; too_large
/// (deepest_use, most_copied_bytes).
Result<SvgOutlines> read_svg_outlines(std::string_view text, Drawing& drawing);

}  // namespace lpq

// Domains from SVG (W3C, Scalable Vector Graphics 1.1, second edition, and SVG 2).
// Outlines are the closed subpaths of <path>, <rect>, <circle>, <ellipse> and <polygon>, and of
// <polyline> and open paths where filling closes them; the fill itself is not looked at
// otherwise. All outlines together follow the even-odd rule: within an outline is material,
// within the next one a hole, within that an island. Open pieces that are not filled (fill none,
// <line>) are joined at their ends, and lines are divided where others end on them; what closes
// is an outline, what stays open inside becomes a polyline.
// An element's id becomes the name of its region and the tag of its edges, or the id of the <use>
// that draws it. <use> draws elements of the same file, also <symbol> and what is in <defs>. <svg>
// within <svg>, and a <symbol> for its <use>, fill their width and height with their viewBox; of
// <switch> the first child is drawn that applies to English text without extensions.
// y points up in a mesh: every y is negated, after all transforms. viewBox, width, height and units
// of the page are ignored but for percentages: coordinates are the drawing's own ("user units").
// Lengths and transforms may be said in attributes and in styles.
// Left out without a word: <clipPath>, <mask>, <pattern>, <marker>, display none and visibility
// hidden; with a warning: <text>, <image>, <use> of other files, and what clip-path and mask would
// hide, which is drawn. Of style sheets (<style>), rules are read whose selectors are a name, a
// class or an id (svg_style.h).
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/domain/domain_file.h"

namespace lpq {

/// Curves become polylines within 2e-4 of the drawing's size. Errors: parse_error, non_finite,
/// empty, with line and byte; too_large where curves have more corners than the text has bytes
/// (and more than a million), and where <use> multiplies (see svg_elements.h).
Result<DomainFile> read_svg_domain(std::string_view text);

}  // namespace lpq

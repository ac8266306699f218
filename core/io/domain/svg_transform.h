// The transforms of SVG elements, in attributes and styles (W3C, SVG 1.1, chapter 7; CSS Transforms
// 1, chapters 4 and 6).
#pragma once

#include <string_view>

#include "io/domain/drawing.h"
#include "io/domain/svg_style.h"
#include "io/domain/svg_values.h"

namespace lpq {

/// Puts the transform of the tag that `xml` read last, about its transform-origin, before `map`.
/// What styles say and nobody can read, or not here, is counted in `not_applied`. Errors:
/// parse_error with its place.
Problem apply_svg_transform(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
                            const LengthUnits& units, Affine& map, Counter& not_applied);

}  // namespace lpq

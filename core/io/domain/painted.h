// What is painted where filled outlines cross: themselves, or each other.
#pragma once

#include <optional>
#include <span>

#include "io/domain/drawing.h"

namespace lpq {

/// How an element is painted inside (W3C, SVG 1.1, chapter 11.3).
enum class FillRule : char { unfilled, nonzero, even_odd };

/// Elements whose outlines cross, touch along their edges or overlap become the borders of all that
/// they paint together; the others stay as they are. `rules` are those of the sources. Gaps
/// narrower than `tolerance` close. Returns where the first ones met; nothing if none did, or so
/// many, or so far away, that the lines stay as they were. Cost about n log n for n edges with
/// their crossings, and in what crosses together its edges times its elements.
std::optional<Vec2> unite_painted(LineWork& lines, std::span<const FillRule> rules,
                                  double tolerance);

/// The even-odd rule with united outlines as one: faces are filled that lie in an odd number of
/// outlines, of united ones in what these paint.
std::vector<char> painted_faces(const LineWork& lines, const NestedFaces& nested);

}  // namespace lpq

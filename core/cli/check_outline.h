// Do the faces of a mesh in the plane lie beside each other, where no domain says what its boundary
// should be?
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/validate.h"

namespace lpq {

/// For a mesh that validate() finds nothing wrong with for `outline`, its own boundary: that faces
/// cover the plane at most once, so that they meet edge to edge. (The number of faces over a point
/// is the winding number of the outline around it, see mesh/validate.h. It is 0 or 1 everywhere if
/// the edges of the outline meet in common vertices only, have their faces alternately around each
/// of these, and every part of the outline turns the way that suits what lies around it.)
/// Exact; at most `limit` violations. Cost about n log n for n edges of the outline.
std::vector<Violation> check_own_outline(std::span<const Vec2> points,
                                         std::span<const std::array<Index, 2>> outline,
                                         std::size_t limit = 10);

}  // namespace lpq

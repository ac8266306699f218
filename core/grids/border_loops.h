// The border of a face as closed lines.
#pragma once

#include <vector>

#include "domain/boundary.h"

namespace lpq {

/// The nodes of the border's loops, the domain on their left, the outer one first; empty if
/// something divides the inside, or if there are two outer ones. Cost O(#nodes).
std::vector<std::vector<Index>> border_loops(const BoundaryMesh& boundary);

/// The number, among the loops of border_loops, of the hole of most area; there must be a hole.
std::size_t largest_hole(const BoundaryMesh& boundary,
                         const std::vector<std::vector<Index>>& loops);

/// Where the nodes of a loop are, unit frame.
std::vector<Vec2> points_of(const BoundaryMesh& boundary, const std::vector<Index>& loop);

/// The centroid of the area inside; it may lie outside.
Vec2 centre_of(const std::vector<Vec2>& polygon);

/// The direction that most of the border keeps, but for quarter turns. Radians.
double axis_of(const BoundaryMesh& boundary);

}  // namespace lpq

// The border of a face as closed lines.
#pragma once

#include <vector>

#include "domain/boundary.h"

namespace lpq {

/// The nodes of the border's loops, the domain on their left, the outer one first; empty if
/// something divides the inside. Cost O(#nodes).
std::vector<std::vector<Index>> border_loops(const BoundaryMesh& boundary);

std::vector<Vec2> points_of(const BoundaryMesh& boundary, const std::vector<Index>& loop);

}  // namespace lpq

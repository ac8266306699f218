// Which points lie inside the domain, for many points at once: a sweep over y keeps the walls that
// cross the sweep line in order; the wall to the left of a point knows what is on its right.
#pragma once

#include <span>
#include <vector>

#include "domain/boundary.h"

namespace lpq {

/// For every point: the region it lies in, none outside. Exact for points off the walls.
/// Cost O((#E + #points) log), every decision an exact orientation.
std::vector<Index> regions_of(const BoundaryMesh& boundary, std::span<const Vec2> points);

}  // namespace lpq

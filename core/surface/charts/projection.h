// Flat parts as they lie: no map is better, and none copes better with needles.
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "surface/charts/part.h"

namespace lpq {

/// Onto the plane of the part, the longest edge of its border along x, its start at the origin.
/// False for parts that are higher than a thousandth of their width, and where borders touch. Cost
/// O(#T log #T).
bool map_projection(const SurfaceMesh& mesh, const Part& part, std::vector<Vec2>& uv);

}  // namespace lpq

// Would a grid be convex if the nodes of its border could move along it?
#pragma once

#include <vector>

#include "mesh/quad_mesh.h"

namespace lpq {

/// On a surface, nodes slide along their curves once all faces are there; in the plane of one face
/// this says whether that can help. Only nodes of `loops` where the border is straight move, by
/// less than half an edge, and only those of quads that are not convex. Cost O(#quads) for each of
/// them.
bool is_convex_after_sliding(QuadMesh grid, const std::vector<std::vector<Index>>& loops);

}  // namespace lpq

// Slender cones whose tip a line ends on: the line comes back to itself round the tip.
#pragma once

#include "surface/features.h"

namespace lpq {

/// Where a face goes round a vertex from one side of a feature edge to its other side and has room
/// for one quad only, that quad would have the same node to both sides of the tip, at every mesh
/// size. One more edge there, opposite that one, becomes a (marked) feature, with corners at its
/// ends: then there are two. Cost O(#T).
void mark_tips(const SurfaceMesh& mesh, SurfaceFeatures& features);

}  // namespace lpq

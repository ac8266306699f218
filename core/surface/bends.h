// Corners that are rounded off at a smaller scale than the mesh.
#pragma once

#include <span>

#include "surface/features.h"

namespace lpq {

/// Adds to features.corner the middles of bends: where a curve turns by a corner's angle within a
/// mesh size and runs on straighter before and after. A mesh whose nodes lie anywhere on such a
/// bend would cut it off. Loops shorter than six sizes are round. Cost O(#V log #V).
void mark_bends(const SurfaceMesh& mesh, std::span<const double> size, double bend_angle,
                SurfaceFeatures& features);

}  // namespace lpq

// Which edges are sharp enough for the mesh to follow them.
#pragma once

#include <span>
#include <vector>

#include "surface/features.h"

namespace lpq {

/// Degrees between the normals at every edge; 0 where there are not two. #E. `size`: of the mesh,
/// #V.
std::vector<double> edge_angles(const SurfaceMesh& mesh, std::span<const double> size,
                                const SurfaceEdges& edges);

/// Sets kind to sharp on edges that are smooth so far, by angle alone.
void mark_sharp_edges(std::span<const double> angles, const FeatureOptions& options,
                      SurfaceFeatures& features);

/// Chains that stand out go on, straight ahead, along less sharp edges.
void extend_sharp_chains(const SurfaceMesh& mesh, std::span<const double> angles,
                         const FeatureOptions& options, SurfaceFeatures& features);

}  // namespace lpq

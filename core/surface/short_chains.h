// Which chains of sharp edges are long enough for the mesh to follow them.
#pragma once

#include <span>

#include "surface/features.h"

namespace lpq {

/// Sets sharp edges back to smooth where they form stubs or heaps that are short for the mesh size.
void drop_short_chains(const SurfaceMesh& mesh, std::span<const double> size,
                       const FeatureOptions& options, SurfaceFeatures& features);

}  // namespace lpq

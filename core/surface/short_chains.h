// Which chains of sharp edges are long enough for the mesh to follow them.
#pragma once

#include <span>

#include "surface/features.h"

namespace lpq {

/// Sets sharp edges back to smooth where the chain that they form is a short stub, or short and
/// does not stand out from the surface beside it.
void drop_short_chains(const SurfaceMesh& mesh, std::span<const double> size,
                       std::span<const double> angles, const FeatureOptions& options,
                       SurfaceFeatures& features);

/// The same where connected chains are short altogether.
void drop_small_heaps(const SurfaceMesh& mesh, std::span<const double> size,
                      std::span<const double> angles, const FeatureOptions& options,
                      SurfaceFeatures& features);

}  // namespace lpq

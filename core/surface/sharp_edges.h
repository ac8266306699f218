// Which edges are sharp enough, and belong to chains long enough, for the mesh to follow them.
#pragma once

#include <span>

#include "surface/features.h"

namespace lpq {

/// Sets kind to sharp on edges that are smooth so far, by angle with hysteresis.
void mark_sharp_edges(const SurfaceMesh& mesh, const FeatureOptions& options,
                      SurfaceFeatures& features);

/// Sets sharp edges back to smooth where they form stubs or heaps that are short for the mesh size.
void drop_short_chains(const SurfaceMesh& mesh, std::span<const double> size,
                       const FeatureOptions& options, SurfaceFeatures& features);

/// cos of an angle in degrees.
double cos_degrees(double angle);

}  // namespace lpq

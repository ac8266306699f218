// Which edges are sharp enough for the mesh to follow them.
#pragma once

#include "surface/features.h"

namespace lpq {

/// Sets kind to sharp on edges that are smooth so far, by angle with hysteresis.
void mark_sharp_edges(const SurfaceMesh& mesh, std::span<const double> size,
                      const FeatureOptions& options, SurfaceFeatures& features);

/// cos of an angle in degrees.
double cos_degrees(double angle);

}  // namespace lpq

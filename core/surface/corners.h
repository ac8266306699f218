// Vertices that stay where they are: the ends of curves.
#pragma once

#include <span>

#include "surface/features.h"

namespace lpq {

/// Fills features.corner from kind and face; see features.h for what is a corner.
void mark_corners(const SurfaceMesh& mesh, std::span<const double> size, double corner_angle,
                  SurfaceFeatures& features);

/// Faces on an edge, one for each half-edge of it, ascending.
std::vector<Index> faces_on_edge(const SurfaceFeatures& features, Index edge);

}  // namespace lpq

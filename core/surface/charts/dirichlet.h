// The map of last resort, free of flips by construction: Tutte's embedding in a circle, relaxed
// towards an isometry by the symmetric Dirichlet energy [Smith, Schaefer 2015; Rabinovich et al.
// 2017], which is infinite where a triangle has no area.
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "surface/charts/part.h"

namespace lpq {

/// False where Tutte's embedding is not free of flips in floating point. uv: #V of the part.
bool map_symmetric_dirichlet(const SurfaceMesh& mesh, const Part& part, std::vector<Vec2>& uv);

}  // namespace lpq

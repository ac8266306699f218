// The plain pattern of a face with four sides: a grid from side to side.
#pragma once

#include <optional>

#include "domain/boundary.h"
#include "mesh/quad_mesh.h"

namespace lpq {

/// Transfinite interpolation [GH73] between the four sides of a disk, in the unit
/// frame. None unless at exactly four nodes of the border one quad is wanted and everywhere else
/// two, opposite sides have as many edges, nothing divides the inside, and every quad comes out
/// convex; and none where far more or fewer quads are `wanted` (the integral of 1/h^2) than its
/// border makes. Cost O(#quads).
std::optional<QuadMesh> mapped_grid(const BoundaryMesh& boundary, double wanted);

}  // namespace lpq

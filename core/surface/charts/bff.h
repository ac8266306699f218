// Boundary first flattening [Sawhney, Crane 2017] with the border's lengths kept (scale factor 1
// there): the turning of the flattened border follows from one Poisson solve, the inside from two
// harmonic extensions with the same factors.
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "surface/charts/intrinsic.h"

namespace lpq {

enum class MapOutcome { mapped, distorted, unsolved };

/// Maps the vertices of a disk (holes filled) whose border is the part's first loop. `distorted`
/// without finishing where the scale factor differs by more than `largest_range` between the
/// surface's largest and smallest half per cent of it. uv: #V of the part.
MapOutcome map_bff(const Part& part, const Intrinsic& disk, double largest_range,
                   std::vector<Vec2>& uv);

}  // namespace lpq

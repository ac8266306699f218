// Conformal maps with a free border: the least area that the map's Dirichlet energy exceeds, with
// two vertices pinned [Levy et al. 2002] or against the trivial map in the mean over the border
// [Mullen et al. 2008]. As complex numbers, one Hermitian system of #V unknowns.
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "surface/charts/intrinsic.h"

namespace lpq {

/// Both false if the system cannot be solved; uv: #V of the part. Holes may be left open.
bool map_lscm(const SurfaceMesh& mesh, const Part& part, const Intrinsic& surface,
              std::vector<Vec2>& uv);
bool map_scp(const Part& part, const Intrinsic& surface, std::vector<Vec2>& uv);

}  // namespace lpq

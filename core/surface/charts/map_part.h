// One part, one map: the methods in order of what they cost, until one passes the checks.
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "surface/charts/checks.h"

namespace lpq {

enum class MapMethod { bff, lscm, scp, symmetric_dirichlet, none_found };

enum class Verdict {
  accepted,
  topology,   // no border, or handles
  flipped,    // triangles are turned over
  crossing,   // the border meets itself
  distorted,  // injective, but sizes or shapes differ too much
};

struct PartMap {
  Verdict verdict = Verdict::topology;
  MapMethod method = MapMethod::none_found;
  std::vector<Vec2> uv;  // #V of the part; meaningless unless accepted
  MapCheck check;
};

/// Tries the methods up to `last` in their order above; those after the first are asked only where
/// a map is not injective. Tells hopeless parts early: `solved` says whether a system was solved.
PartMap map_part(const SurfaceMesh& mesh, const Part& part, const MapLimits& limits, MapMethod last,
                 bool& solved);

}  // namespace lpq

// The small sets of faces around a vertex that are worth refilling, cheapest first.
#pragma once

#include "cleanup/quad_topology.h"

namespace lpq {

using Cavity = std::vector<Index>;

/// Pairs and triples of neighbouring faces at v, the star of v, the stars of its neighbours, and
/// stars with one more face or with the star of a neighbour. Fixed vertices have no star of their
/// own: they stay on the loop. `wide` adds the larger ones.
std::vector<Cavity> cavities_at(const QuadTopology& mesh, Index v, bool wide);

}  // namespace lpq

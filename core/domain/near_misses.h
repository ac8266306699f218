// Walls that all but meet. What differs by rounding is exact to the checks before, and yet nobody
// means it: regions beside each other whose common edge was computed twice, holes a hair from the
// outline.
#pragma once

#include "domain/domain.h"

namespace lpq {

/// Adds warnings of regions that run along each other across a hair of nothing, without a common
/// edge. Error: touching, for walls across an inside too narrow for any mesh. Cost about n log n.
Problem judge_near_misses(Domain& domain);

}  // namespace lpq

// Which loop lies directly inside which other, for many loops at once.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

struct LoopTree {
  std::vector<Index> parent;  // of each loop: the smallest loop around it, none = outside all
  std::vector<Index> depth;   // of each loop: the number of loops around it
  std::vector<Index> around;  // of each probe: the smallest loop around it, none = outside all
};

/// Loops may share corners and whole edges (neighbours, islands that touch), but not cross; of
/// equal loops the first is the outer one. Probes on an edge count as on either side. Loops that
/// cross get some answer. Exact; cost O(n log n).
LoopTree nest_loops(std::span<const std::vector<Vec2>> loops, std::span<const Vec2> probes = {});

}  // namespace lpq

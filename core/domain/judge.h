// The verdict on an outline: is every region a simple outer loop with holes strictly inside?
#pragma once

#include <optional>
#include <vector>

#include "domain/outline.h"

namespace lpq {

/// What the verdict learned about each loop (#loops).
struct LoopRoles {
  std::vector<Index> outer;      // #regions  the chain that is the outer loop
  std::vector<int> orientation;  // #loops  sign of the area as given
  std::vector<double> area;      // #loops  signed, unit frame
};

/// One error is reported, the gravest first: crossing edges, loops without extent, misplaced holes,
/// overlapping edges, touching. Policy: loops of one region may not even touch; loops of different
/// regions may share whole edges and corners. Cost about n log n.
Result<LoopRoles> judge_loops(const Outline& outline, bool outer_first);

}  // namespace lpq

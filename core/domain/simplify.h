// Fewer boundary vertices within a stated distance, for boundaries drawn much finer than the mesh.
#pragma once

#include <vector>

#include "domain/domain.h"

namespace lpq {

struct SimplifiedBoundary {
  std::vector<Segment> segments;
  std::vector<char> used;  // #P  the point is still there
  double deviation = 0;    // largest distance of a dropped point from the new boundary's edge
};

/// Corners where anything changes (tag, region, more than two edges, a tagged point) always stay.
/// The new edges meet nowhere but in common ends, and no kept point changes sides; where the
/// tolerance alone would break that, more points stay. tolerance 0 keeps everything.
SimplifiedBoundary simplify_boundary(const Domain& domain, double tolerance);

}  // namespace lpq

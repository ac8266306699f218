// Ways to fill a polygon of 2 to 6 corners: as one block (block.h), or cut in two blocks by one
// line of k edges between two of its sides. One cut is enough to place a pair of irregular vertices
// wherever the numbers of edges allow.
#pragma once

#include "patches/block.h"

namespace lpq {

inline constexpr int least_corners = 2, most_corners = 6;

/// Counter-clockwise, beginning at a corner.
struct Polygon {
  std::vector<Vec2> points;   // #L
  std::vector<double> size;   // #L  target edge length at each point
  std::vector<Index> corner;  // ascending positions in `points`, the first is 0

  int corners() const { return static_cast<int>(corner.size()); }
  int side_length(int i) const {
    return (i + 1 < corners() ? corner[i + 1] : static_cast<Index>(points.size())) - corner[i];
  }
  Index at(int side, int step) const {
    const Index i = corner[side] + step;
    return i < static_cast<Index>(points.size()) ? i : 0;
  }
};

struct Plan {
  int first_side = none, first_step = 0;  // the cut begins here; none: no cut
  int second_side = none, second_step = 0;
  int edges = 0;      // of the cut
  int irregular = 0;  // interior vertices that will not have four quads
  double misfit = 0;  // how far the cut is from its natural number of edges
};

struct PlanOptions {
  int most_irregular = 2;
  int places_per_side = 10;
  int count = 4;  // plans returned
};

/// The most promising plans, fewest irregular vertices first, then best fitting; neighbours of a
/// better plan are left out. Cost O(corners^2 places^2).
std::vector<Plan> make_plans(const Polygon& polygon, const PlanOptions& options);

/// Carries a plan out: points 0 .. L-1 are the polygon's.
Filling fill(const Polygon& polygon, const Plan& plan);

}  // namespace lpq

// Where opposite sides of a face want the same number of edges.
#pragma once

#include <span>
#include <vector>

#include "surface/curves.h"

namespace lpq {

/// The edges of a curve count `factor` times in a sum.
struct CountTerm {
  Index curve = none, factor = 0;
};

struct CountSums {
  Csr<CountTerm> terms;               // #sums
  std::vector<Index> constant;        // #sums  added to the terms
  std::vector<char> only_parity;      // #sums  wanted: even; of the others: zero
  std::vector<char> across_ring;      // #sums  of one without curvature, or between_circles
  std::vector<char> between_circles;  // #sums  of small ones, the borders of a narrow ring
  std::vector<Index> bent;            // #C  count of a curve that turns on its way; 0 of others
};

/// Going round a border of a face and turning by right angles (rounded) at its corners, what runs
/// one way must come back: a border that turns four times in all has two sums, one for each of its
/// two directions, as a mesh without irregular vertices has them [WWBB96: submapping]; the two
/// borders of a ring (no other is its outline) share one, whatever holes are between them. A bend
/// that is small beside the mesh turns like a corner: on either side of it the curve gets whole
/// edges, a constant in sums. Borders without such sums only ask for an even number each, for an
/// odd one closes on no grid. `steps`: int ds/h of each curve, #C. Cost O(#T log #T).
CountSums side_balances(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                        const SurfaceCurves& curves, std::span<const double> steps);

}  // namespace lpq

// Where opposite sides of a face want the same number of edges.
#pragma once

#include <vector>

#include "surface/curves.h"

namespace lpq {

/// The edges of a curve count `factor` times in a sum.
struct CountTerm {
  Index curve = none, factor = 0;
};

struct CountSums {
  Csr<CountTerm> terms;           // #sums
  std::vector<char> only_parity;  // #sums  wanted: even; of the others: zero
};

/// Going round a border of a face and turning by right angles (rounded) at its corners, what runs
/// one way must come back: a border that turns four times in all has two sums, one for each of its
/// two directions, as a mesh without irregular vertices has them [WWBB96: submapping]; the two
/// borders of a ring share one. Borders without such sums only ask for an even number, once for
/// each face. Cost O(#T).
CountSums side_balances(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                        const SurfaceCurves& curves);

}  // namespace lpq

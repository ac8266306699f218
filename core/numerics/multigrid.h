// Large Laplacian systems solved to a few digits, in time proportional to their size.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "base/index.h"

namespace lpq {

struct Coupling {
  Index row = none;
  double value = 0;
};

/// Whole rows of a symmetric matrix, the diagonal apart. Duplicates are summed.
struct SparseRows {
  Csr<Coupling> couplings;
  std::vector<double> diagonal;

  Index count() const { return static_cast<Index>(diagonal.size()); }
};

/// x with A x = b but for an error of about `tolerance` in the norm of A, as a share of x; A is
/// positive definite, nearly all of its couplings negative. Conjugate gradients, preconditioned by
/// a V-cycle over groups of up to four rows. False, and x of no use, where that does not converge.
bool solve_nearly(SparseRows a, std::span<const double> b, double tolerance,
                  std::vector<double>& x);

}  // namespace lpq

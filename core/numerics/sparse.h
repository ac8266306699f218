// Sparse symmetric positive definite systems: the one place that uses Eigen.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"

namespace lpq {

struct Triplet {
  Index row = 0, column = 0;
  double value = 0;  // duplicates are summed
};

enum class SparseStatus { ok, not_positive_definite, not_converged };

/// Solves A x = b for several right-hand sides by sparse Cholesky (LDL^T, fill-reducing order).
/// `triplets` hold the lower triangle or all of A. `x` and `b` hold `columns` blocks of n values.
/// Deterministic; cost is that of the factorisation. x is left zero unless the status is ok.
SparseStatus solve_spd(Index n, std::span<const Triplet> triplets, std::span<const double> b,
                       Index columns, std::vector<double>& x);

}  // namespace lpq

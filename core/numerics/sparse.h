// Sparse symmetric and Hermitian positive definite systems: the one place that uses Eigen.
#pragma once

#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "base/index.h"

namespace lpq {

template <class Scalar>
struct Entry {
  Index row = 0, column = 0;
  Scalar value{};  // duplicates are summed
};
using Triplet = Entry<double>;
using ComplexTriplet = Entry<std::complex<double>>;

enum class SparseStatus { ok, not_positive_definite };

/// A matrix factorised once (sparse LDL^T or LDL^H, fill-reducing order) for many right-hand sides;
/// Scalar is double or std::complex<double>. Deterministic.
template <class Scalar>
class SparseFactor {
 public:
  /// `entries` hold the lower triangle or all of A; its diagonal must be real.
  SparseFactor(Index n, std::span<const Entry<Scalar>> entries);
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;
  ~SparseFactor();

  /// New values in the same places: keeps the fill-reducing order, which costs about as much as the
  /// numbers do.
  void refactor(std::span<const Entry<Scalar>> entries);
  SparseStatus status() const;
  /// x = A^-1 b; both hold n values and may be the same. Only where the status is ok.
  void solve(std::span<const Scalar> b, std::span<Scalar> x) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

extern template class SparseFactor<double>;
extern template class SparseFactor<std::complex<double>>;

/// Solves A x = b for several right-hand sides by sparse Cholesky (LDL^T, fill-reducing order).
/// `triplets` hold the lower triangle or all of A. `x` and `b` hold `columns` blocks of n values.
/// Deterministic; cost is that of the factorisation. x is left zero unless the status is ok.
SparseStatus solve_spd(Index n, std::span<const Triplet> triplets, std::span<const double> b,
                       Index columns, std::vector<double>& x);

}  // namespace lpq

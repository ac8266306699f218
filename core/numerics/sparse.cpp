#include "numerics/sparse.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "base/check.h"

namespace lpq {
namespace {

template <class Scalar>
using Matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, Index>;
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

template <class Scalar>
Matrix<Scalar> lower_triangle(Index n, std::span<const Entry<Scalar>> entries) {
  std::vector<Eigen::Triplet<Scalar, Index>> kept;
  kept.reserve(entries.size());
  for (const Entry<Scalar>& t : entries)
    if (t.row >= t.column) kept.emplace_back(t.row, t.column, t.value);
  Matrix<Scalar> a(n, n);
  a.setFromTriplets(kept.begin(), kept.end());
  return a;
}

/// Approximate minimum degree. Where entries are is all that counts: the real parts stand for the
/// whole, so that there is one ordering for both scalars. Nor is A + A^T formed, as what Eigen
/// orders by itself would: A comes with both triangles.
struct FillReducingOrder {
  using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index>;

  template <class Scalar>
  void operator()(const Matrix<Scalar>& a, PermutationType& order) const {
    const Matrix<double> pattern = a.real();
    Eigen::AMDOrdering<Index>()(pattern.selfadjointView<Eigen::Lower>(), order);
  }
};

}  // namespace

template <class Scalar>
struct SparseFactor<Scalar>::Data {
  Index n = 0;
  Eigen::SimplicialLDLT<Matrix<Scalar>, Eigen::Lower, FillReducingOrder> ldlt;
  SparseStatus status = SparseStatus::ok;

  void factorise(const Matrix<Scalar>& a) {
    if (n == 0) return;
    ldlt.factorize(a);
    bool positive = ldlt.info() == Eigen::Success;
    if (positive) positive = ldlt.vectorD().real().minCoeff() > 0;
    status = positive ? SparseStatus::ok : SparseStatus::not_positive_definite;
  }
};

template <class Scalar>
SparseFactor<Scalar>::SparseFactor(Index n, std::span<const Entry<Scalar>> entries)
    : data_(std::make_unique<Data>()) {
  data_->n = n;
  const Matrix<Scalar> a = lower_triangle(n, entries);
  if (n > 0) data_->ldlt.analyzePattern(a);
  data_->factorise(a);
}
template <class Scalar>
SparseFactor<Scalar>::SparseFactor(SparseFactor&&) noexcept = default;
template <class Scalar>
SparseFactor<Scalar>& SparseFactor<Scalar>::operator=(SparseFactor&&) noexcept = default;
template <class Scalar>
SparseFactor<Scalar>::~SparseFactor() = default;

template <class Scalar>
void SparseFactor<Scalar>::refactor(std::span<const Entry<Scalar>> entries) {
  data_->factorise(lower_triangle(data_->n, entries));
}

template <class Scalar>
SparseStatus SparseFactor<Scalar>::status() const {
  return data_->status;
}

template <class Scalar>
void SparseFactor<Scalar>::solve(std::span<const Scalar> b, std::span<Scalar> x) const {
  const Index n = data_->n;
  LPQ_ASSERT(data_->status == SparseStatus::ok && b.size() == x.size());
  LPQ_ASSERT(b.size() == static_cast<std::size_t>(n));
  if (n == 0) return;
  // Eigen's own solve() would divide complex numbers by the diagonal, whose last bits depend on the
  // compiler's support library.
  const auto& ldlt = data_->ldlt;
  Vector<Scalar> y = ldlt.permutationP() * Eigen::Map<const Vector<Scalar>>(b.data(), n);
  ldlt.matrixL().solveInPlace(y);
  y = ldlt.vectorD().real().asDiagonal().inverse() * y;
  ldlt.matrixU().solveInPlace(y);
  Eigen::Map<Vector<Scalar>>(x.data(), n) = ldlt.permutationPinv() * y;
}

template class SparseFactor<double>;
template class SparseFactor<std::complex<double>>;

SparseStatus solve_spd(Index n, std::span<const Triplet> triplets, std::span<const double> b,
                       Index columns, std::vector<double>& x) {
  LPQ_ASSERT(b.size() == static_cast<std::size_t>(n) * static_cast<std::size_t>(columns));
  x.assign(b.size(), 0.0);
  const SparseFactor<double> factor(n, triplets);
  if (factor.status() != SparseStatus::ok) return factor.status();
  for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c)
    factor.solve(b.subspan(c * n, n), std::span(x).subspan(c * n, n));
  return SparseStatus::ok;
}

}  // namespace lpq

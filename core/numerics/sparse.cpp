#include "numerics/sparse.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "base/check.h"

namespace lpq {

SparseStatus solve_spd(Index n, std::span<const Triplet> triplets, std::span<const double> b,
                       Index columns, std::vector<double>& x) {
  LPQ_ASSERT(b.size() == static_cast<std::size_t>(n) * static_cast<std::size_t>(columns));
  x.assign(b.size(), 0.0);
  if (n == 0) return SparseStatus::ok;
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(triplets.size());
  for (const Triplet& t : triplets)
    if (t.row >= t.column) entries.emplace_back(t.row, t.column, t.value);
  Eigen::SparseMatrix<double, Eigen::ColMajor, Index> a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::SimplicialLDLT<decltype(a), Eigen::Lower> factor(a);
  if (factor.info() != Eigen::Success || factor.vectorD().minCoeff() <= 0)
    return SparseStatus::not_positive_definite;
  for (Index c = 0; c < columns; ++c) {
    const Eigen::Map<const Eigen::VectorXd> rhs(b.data() + static_cast<std::size_t>(c) * n, n);
    Eigen::Map<Eigen::VectorXd>(x.data() + static_cast<std::size_t>(c) * n, n) = factor.solve(rhs);
  }
  return SparseStatus::ok;
}

}  // namespace lpq

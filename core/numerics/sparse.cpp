#include "numerics/sparse.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <complex>

#include "base/check.h"
#include "base/csr.h"

namespace lpq {
namespace {

template <class Scalar>
using Matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, Index>;
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// Where an entry stands.
struct Cell {
  Index row = 0, column = 0;
};

/// One triangle of a matrix by columns. Eigen would lay it out, too, but over copies of all values
/// and in code of its own for every scalar.
struct Triangle {
  Csr<Index> rows;           // #columns
  std::vector<Index> order;  // of the entries in the triangle, by columns
  std::vector<Index> place;  // #entries given  in rows.values; none: in the other triangle
};

/// The entries named by `order`; in each column they keep that order, those of one cell together.
Triangle lay_out(Index n, std::span<const Cell> cells, std::span<const Index> order) {
  Csr<Index> columns = csr_from<Index>(static_cast<std::size_t>(n), [&](auto&& emit) {
    for (const Index i : order) emit(cells[i].column, i);
  });
  Triangle triangle;
  triangle.place.assign(cells.size(), none);
  for (Index column = 0; column < n; ++column) {
    Index row = none;
    for (const Index i : columns.row(column)) {
      if (cells[i].row != row) triangle.rows.values.push_back(row = cells[i].row);
      triangle.place[i] = static_cast<Index>(triangle.rows.values.size()) - 1;
    }
    triangle.rows.end_row();
  }
  triangle.order = std::move(columns.values);
  return triangle;
}

/// The lower triangle, rows ascending in every column.
Triangle lower_triangle(Index n, std::span<const Cell> cells) {
  const Csr<Index> rows = csr_from<Index>(static_cast<std::size_t>(n), [&](auto&& emit) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].row >= cells[i].column) emit(cells[i].row, static_cast<Index>(i));
  });
  return lay_out(n, cells, rows.values);
}

/// The same entries as upper triangle of the matrix whose rows and columns are renumbered.
Triangle renumbered(const Triangle& lower, std::vector<Cell> cells, std::span<const Index> number) {
  for (Cell& cell : cells) {
    const auto [first, last] = std::minmax(number[cell.row], number[cell.column]);
    cell = {first, last};
  }
  return lay_out(lower.rows.rows(), cells, lower.order);
}

/// All zero.
template <class Scalar>
Matrix<Scalar> matrix_with(const Csr<Index>& rows) {
  Matrix<Scalar> a(rows.rows(), rows.rows());
  a.resizeNonZeros(static_cast<Eigen::Index>(rows.values.size()));
  std::copy(rows.offsets.begin(), rows.offsets.end(), a.outerIndexPtr());
  std::copy(rows.values.begin(), rows.values.end(), a.innerIndexPtr());
  std::fill(a.valuePtr(), a.valuePtr() + rows.values.size(), Scalar{});
  return a;
}

/// New numbers by approximate minimum degree. Where entries are is all that counts. Nor is A + A^T
/// formed, as what Eigen orders by itself would: A comes with both triangles.
std::vector<Index> fill_reducing_numbers(const Csr<Index>& lower_rows) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> order;
  const Matrix<double> pattern = matrix_with<double>(lower_rows);
  Eigen::AMDOrdering<Index>()(pattern.selfadjointView<Eigen::Lower>(), order);
  std::vector<Index> number(static_cast<std::size_t>(lower_rows.rows()));
  for (Index k = 0; k < lower_rows.rows(); ++k) number[order.indices()[k]] = k;
  return number;
}

}  // namespace

template <class Scalar>
struct SparseFactor<Scalar>::Data {
  Index n = 0;
  std::vector<Index> number;  // #n  of the unknowns in the factor
  Eigen::SimplicialLDLT<Matrix<Scalar>, Eigen::Upper, Eigen::NaturalOrdering<Index>> ldlt;
  SparseStatus status = SparseStatus::ok;

  void factorise(std::span<const Entry<Scalar>> entries) {
    if (n == 0) return;
    std::vector<Cell> cells;
    for (const Entry<Scalar>& entry : entries) cells.push_back({entry.row, entry.column});
    const Triangle lower = lower_triangle(n, cells);
    const bool is_first = number.empty();
    if (is_first) number = fill_reducing_numbers(lower.rows);
    const Triangle upper = renumbered(lower, std::move(cells), number);
    Matrix<Scalar> a = matrix_with<Scalar>(upper.rows);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const auto& [row, column, value] = entries[i];
      if (upper.place[i] != none)
        a.valuePtr()[upper.place[i]] +=
            number[row] > number[column] ? Eigen::numext::conj(value) : value;
    }
    if (is_first) ldlt.analyzePattern(a);
    ldlt.factorize(a);
    const auto is_positive = [](const Scalar& pivot) { return std::real(pivot) > 0; };  // no NaN
    const auto& pivots = ldlt.vectorD();
    const bool positive = ldlt.info() == Eigen::Success &&
                          std::all_of(pivots.data(), pivots.data() + pivots.size(), is_positive);
    status = positive ? SparseStatus::ok : SparseStatus::not_positive_definite;
  }
};

template <class Scalar>
SparseFactor<Scalar>::SparseFactor(Index n, std::span<const Entry<Scalar>> entries)
    : data_(std::make_unique<Data>()) {
  data_->n = n;
  data_->factorise(entries);
}
template <class Scalar>
SparseFactor<Scalar>::SparseFactor(SparseFactor&&) noexcept = default;
template <class Scalar>
SparseFactor<Scalar>& SparseFactor<Scalar>::operator=(SparseFactor&&) noexcept = default;
template <class Scalar>
SparseFactor<Scalar>::~SparseFactor() = default;

template <class Scalar>
void SparseFactor<Scalar>::refactor(std::span<const Entry<Scalar>> entries) {
  data_->factorise(entries);
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
  Vector<Scalar> y(n);
  for (Index i = 0; i < n; ++i) y[data_->number[i]] = b[i];
  ldlt.matrixL().solveInPlace(y);
  y = ldlt.vectorD().real().asDiagonal().inverse() * y;
  ldlt.matrixU().solveInPlace(y);
  for (Index i = 0; i < n; ++i) x[i] = y[data_->number[i]];
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

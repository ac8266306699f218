// The sparse solver on systems whose solution is known.
#include "numerics/sparse.h"

#include <algorithm>
#include <cmath>

#include "catch.h"

using namespace lpq;

namespace {

// The five-point Laplacian on a side x side grid with zero boundary values; lower triangle only.
std::vector<Triplet> grid_laplacian(Index side) {
  std::vector<Triplet> entries;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i) {
      const Index k = j * side + i;
      entries.push_back({k, k, 4});
      if (i > 0) entries.push_back({k, k - 1, -1});
      if (j > 0) entries.push_back({k, k - side, -1});
    }
  return entries;
}

}  // namespace

TEST_CASE("a Laplace system is solved for several right-hand sides") {
  constexpr Index side = 30, n = side * side;
  const std::vector<Triplet> a = grid_laplacian(side);
  std::vector<double> wanted(2 * n);
  for (Index k = 0; k < 2 * n; ++k) wanted[k] = std::sin(0.1 * k) + (k < n ? 1 : -2);
  std::vector<double> b(2 * n, 0.0), x;
  for (Index c = 0; c < 2; ++c)
    for (const Triplet& t : a) {
      b[c * n + t.row] += t.value * wanted[c * n + t.column];
      if (t.row != t.column) b[c * n + t.column] += t.value * wanted[c * n + t.row];
    }
  REQUIRE(solve_spd(n, a, b, 2, x) == SparseStatus::ok);
  for (Index k = 0; k < 2 * n; ++k) CHECK(std::abs(x[k] - wanted[k]) < 1e-11);
}

TEST_CASE("duplicates are summed, an empty system is solved, a singular one is refused") {
  std::vector<double> x;
  CHECK(solve_spd(0, {}, {}, 1, x) == SparseStatus::ok);
  const std::vector<Triplet> twice{{0, 0, 1}, {0, 0, 1}};
  const std::vector<double> b{6};
  REQUIRE(solve_spd(1, twice, b, 1, x) == SparseStatus::ok);
  CHECK(x[0] == 3);
  const std::vector<Triplet> singular{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}};
  const std::vector<double> ones{1, 2};
  CHECK(solve_spd(2, singular, ones, 1, x) == SparseStatus::not_positive_definite);
}

TEST_CASE("a Hermitian system is factorised once, and again with new values") {
  // A twisted Laplacian: neighbours are compared after a rotation, as crosses are across edges.
  using Complex = std::complex<double>;
  constexpr Index n = 200;
  std::vector<Complex> wanted(n), b(n), x(n);
  for (Index k = 0; k < n; ++k) wanted[k] = {std::cos(0.3 * k), std::sin(0.7 * k)};
  std::vector<ComplexTriplet> entries;
  SparseFactor<Complex> factor(0, {});
  for (const double shift : {0.1, 2.0}) {
    entries.clear();
    for (Index k = 0; k < n; ++k) {
      entries.push_back({k, k, 2 + shift});
      if (k > 0) entries.push_back({k, k - 1, -Complex(std::cos(k), std::sin(k))});
    }
    std::fill(b.begin(), b.end(), Complex{});
    for (const ComplexTriplet& t : entries) {
      b[t.row] += t.value * wanted[t.column];
      if (t.row != t.column) b[t.column] += std::conj(t.value) * wanted[t.row];
    }
    if (shift < 1)
      factor = SparseFactor<Complex>(n, entries);
    else
      factor.refactor(entries);
    REQUIRE(factor.status() == SparseStatus::ok);
    factor.solve(b, x);
    for (Index k = 0; k < n; ++k) CHECK(std::abs(x[k] - wanted[k]) < 1e-12);
  }
  factor.refactor(std::vector<ComplexTriplet>{{0, 0, -1}});
  CHECK(factor.status() == SparseStatus::not_positive_definite);
}

TEST_CASE("entries may come in any order and in both triangles") {
  using Complex = std::complex<double>;
  constexpr Index n = 60;
  std::vector<ComplexTriplet> lower, whole;
  for (Index k = 0; k < n; ++k) {
    lower.push_back({k, k, 9});
    for (const Index other : {k - 1, k - 7})
      if (other >= 0) lower.push_back({k, other, Complex(std::cos(k), std::sin(other))});
  }
  for (auto t = lower.rbegin(); t != lower.rend(); ++t) {
    whole.push_back(*t);
    if (t->row != t->column) whole.push_back({t->column, t->row, std::conj(t->value)});
  }
  std::vector<Complex> b(n), x(n), y(n);
  for (Index k = 0; k < n; ++k) b[k] = {std::sin(0.2 * k), 1};
  SparseFactor<Complex>(n, lower).solve(b, x);
  SparseFactor<Complex>(n, whole).solve(b, y);
  CHECK(x == y);
  std::vector<Complex> residual = b;
  for (const ComplexTriplet& t : whole) residual[t.row] -= t.value * x[t.column];
  for (const Complex& r : residual) CHECK(std::abs(r) < 1e-14 * n);
}

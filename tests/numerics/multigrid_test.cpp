// Systems solved to a few digits, against factors.
#include "numerics/multigrid.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "numerics/sparse.h"

using namespace lpq;

namespace {

/// The Laplacian of an n x n grid with weights between 1 and `contrast`, zero outside it.
SparseRows grid_laplacian(Index n, double contrast) {
  SparseRows a;
  Rng rng(5);
  std::vector<double> across, up;  // edges to the left and below
  for (Index i = 0; i < (n + 1) * (n + 1); ++i) {
    across.push_back(rng.between(1, contrast));
    up.push_back(rng.between(1, contrast));
  }
  const auto at = [=](Index x, Index y) { return y * n + x; };
  const auto couple = [&](Index x, Index y, double weight, double& diagonal) {
    diagonal += weight;
    if (x >= 0 && x < n && y >= 0 && y < n) a.couplings.values.push_back({at(x, y), -weight});
  };
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      double diagonal = 0;
      const Index edge = y * (n + 1) + x;
      couple(x - 1, y, across[edge], diagonal);
      couple(x + 1, y, across[edge + 1], diagonal);
      couple(x, y - 1, up[edge], diagonal);
      couple(x, y + 1, up[edge + n + 1], diagonal);
      a.couplings.end_row();
      a.diagonal.push_back(diagonal);
    }
  return a;
}

std::vector<double> exact(const SparseRows& a, const std::vector<double>& b) {
  std::vector<Triplet> entries;
  for (Index i = 0; i < a.count(); ++i) {
    entries.push_back({i, i, a.diagonal[i]});
    for (const auto& [j, value] : a.couplings.row(i)) entries.push_back({i, j, value});
  }
  std::vector<double> x;
  REQUIRE(solve_spd(a.count(), entries, b, 1, x) == SparseStatus::ok);
  return x;
}

/// x^T A x
double energy(const SparseRows& a, const std::vector<double>& x) {
  double sum = 0;
  for (Index i = 0; i < a.count(); ++i) {
    double row = a.diagonal[i] * x[i];
    for (const auto& [j, value] : a.couplings.row(i)) row += value * x[j];
    sum += x[i] * row;
  }
  return sum;
}

}  // namespace

TEST_CASE("a system is solved to the tolerance in the norm of its matrix") {
  for (const Index n : {3, 40, 150})
    for (const double contrast : {1.0, 100.0})
      for (const double tolerance : {1e-2, 1e-6}) {
        const SparseRows a = grid_laplacian(n, contrast);
        Rng rng(7);
        std::vector<double> b, x;
        for (Index i = 0; i < a.count(); ++i) b.push_back(rng.between(-1, 3));
        REQUIRE(solve_nearly(a, b, tolerance, x));
        std::vector<double> error = exact(a, b);
        const double whole = energy(a, error);
        for (std::size_t i = 0; i < error.size(); ++i) error[i] -= x[i];
        CHECK(std::sqrt(energy(a, error) / whole) < 3 * tolerance);
      }
}

TEST_CASE("zero is the solution for zero") {
  std::vector<double> x;
  REQUIRE(solve_nearly(grid_laplacian(40, 1), std::vector<double>(1600, 0.0), 1e-3, x));
  CHECK(x == std::vector<double>(1600, 0.0));
}

TEST_CASE("a matrix that is not positive definite is told") {
  SparseRows a = grid_laplacian(40, 1);
  a.diagonal[17] = -1;
  std::vector<double> x;
  CHECK(!solve_nearly(a, std::vector<double>(1600, 1.0), 1e-3, x));
}

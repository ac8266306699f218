#include "surface/cross_system.h"

#include <cmath>

#include "base/rng.h"

namespace lpq {
namespace {

using Complex = std::complex<double>;

// Times of the diffusion steps as shares of the surface's area: long ones let misplaced pairs of
// singularities meet and vanish, short ones settle those that stay.
constexpr double diffusion_shares[] = {0.1, 0.01, 0.001};
// Keeps the matrix regular where nothing is prescribed and a field exists that does not bend.
constexpr double shift = 1e-9;
// Inverse iteration ends when a step turns the field by less than this in the mean; the diffusion
// steps smooth the rest away.
constexpr double converged = 0.01;
constexpr int most_inverse_iterations = 40;
constexpr int renormalisations = 8;  // in the diffusion steps of one length

class CrossSolver {
 public:
  explicit CrossSolver(const CrossSystem& system) : system_(system) {}

  std::vector<Complex> solve() {
    x_.assign(system_.rhs.size(), {});
    SparseFactor<Complex> factor(system_.rows(), matrix_with(0));
    if (factor.status() != SparseStatus::ok) return std::move(x_);
    factor.solve(system_.rhs, x_);
    if (system_.free_components > 0) iterate_inverse(factor);
    restore_length();
    for (const double share : diffusion_shares) diffuse(factor, share);
    return std::move(x_);
  }

 private:
  bool is_free(Index row) const { return system_.free_component[row] != none; }

  std::vector<ComplexTriplet> matrix_with(double mass) const {
    std::vector<ComplexTriplet> entries = system_.stiffness;
    for (Index row = 0; row < system_.rows(); ++row)
      entries.push_back({row, row, mass * system_.mass[row] + (is_free(row) ? shift : 0)});
    return entries;
  }

  // Every component has a smallest eigenvalue of its own, hence a length of its own.
  void normalise_free_components() {
    std::vector<double> norm2(system_.free_components, 0.0);
    for (Index row = 0; row < system_.rows(); ++row)
      if (is_free(row))
        norm2[system_.free_component[row]] += system_.mass[row] * squared_norm(x_[row]);
    for (Index row = 0; row < system_.rows(); ++row) {
      if (!is_free(row)) continue;
      const double n = norm2[system_.free_component[row]];
      if (n > 0) x_[row] = (1 / std::sqrt(n)) * x_[row];
    }
  }

  void iterate_inverse(const SparseFactor<Complex>& factor) {
    Rng rng(1);
    for (Index row = 0; row < system_.rows(); ++row) {
      if (!is_free(row)) continue;
      const double re = rng.between(-1, 1), im = rng.between(-1, 1);
      x_[row] = {re, im};
    }
    std::vector<Complex> b(system_.rows()), before;
    for (int i = 0; i < most_inverse_iterations; ++i) {
      before = x_;
      for (Index row = 0; row < system_.rows(); ++row)
        b[row] = is_free(row) ? system_.mass[row] * x_[row] : system_.rhs[row];
      factor.solve(b, x_);
      normalise_free_components();
      double change = 0;
      for (Index row = 0; row < system_.rows(); ++row)
        if (is_free(row)) change += system_.mass[row] * squared_norm(x_[row] - before[row]);
      if (change < converged * converged * system_.free_components) break;
    }
  }

  void restore_length() {
    for (Complex& x : x_) x = unit_cross(x);
  }

  void diffuse(SparseFactor<Complex>& factor, double share) {
    factor.refactor(matrix_with(1 / share));
    if (factor.status() != SparseStatus::ok) return;
    std::vector<Complex> b(system_.rows());
    for (int i = 0; i < renormalisations; ++i) {
      for (Index row = 0; row < system_.rows(); ++row)
        b[row] = system_.rhs[row] + (system_.mass[row] / share) * x_[row];
      factor.solve(b, x_);
      restore_length();
    }
  }

  const CrossSystem& system_;
  std::vector<Complex> x_;  // #rows
};

}  // namespace

Complex unit_cross(Complex z) {
  const double norm = std::sqrt(squared_norm(z));
  return norm > 0 ? z / norm : z;
}

std::vector<Complex> solve_cross_system(const CrossSystem& system) {
  return CrossSolver(system).solve();
}

}  // namespace lpq

// What the shape energies in the plane and in space (shape_energy.h) have in common: the terms of
// a corner, which do not ask where it lies. Inline, as what their kernels are made of.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lpq {

// With eps = 0 a corner must keep at least this share of its face's unit of area: far above
// rounding, far below any angle a person would accept.
inline constexpr double least_corner = 1e-9;
// The length term levels off here (edges four times too long or short): where the 1D mesh forces
// such lengths, they must not outweigh everything else.
inline constexpr double saturation = 16;
// Much later for short ones: a quad with one side next to nothing is a triangle, of a fair eta.
inline constexpr double saturation_of_short = 256;

// atan(t) for |t| <= 1, error below 3e-10: Chebyshev interpolation of atan(t)/t in t^2. N at once:
// the loops over corners are what compilers turn into vector instructions.
template <std::size_t N>
std::array<double, N> small_arc_tangents(const std::array<double, N>& t) {
  constexpr std::array<double, 11> c = {
      0.9999999995535378,   -0.33333322488913208,   0.19999558100397521,  -0.14278576025162701,
      0.1105077127778412,   -0.087850432880911142,  0.066852815272371913, -0.043928410811433227,
      0.021912945885863525, -0.0070306694584457777, 0.0010576074313963289};
  std::array<double, N> s, sum;
  for (std::size_t k = 0; k < N; ++k) s[k] = t[k] * t[k];
  for (std::size_t k = 0; k < N; ++k) sum[k] = c[10];
  for (std::size_t i = 10; i-- > 0;)
    for (std::size_t k = 0; k < N; ++k) sum[k] = sum[k] * s[k] + c[i];
  for (std::size_t k = 0; k < N; ++k) sum[k] *= t[k];
  return sum;
}

inline double eighth_root(double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }

/// The mean ratio of a corner, and its derivatives.
struct MeanRatioTerm {
  double value = 0;
  double by_l_twice = 0;  // for an edge e in l = |e|^2 + ..
  double by_j = 0;
};

inline MeanRatioTerm mean_ratio_term(double l, double j, double w, double eps) {
  const double root = std::sqrt(j * j + eps * eps);
  // For j < 0 the difference j + root would cancel.
  const double chi = j >= 0 ? 0.5 * (j + root) : 0.5 * eps * eps / (root - j);
  const double inverse = 1 / chi;
  const double by_chi = -0.5 * l * inverse * inverse + 0.5 * w * (1 - inverse * inverse);
  return {0.5 * l * inverse + 0.5 * w * (chi + inverse), inverse,
          by_chi * chi / root};  // d chi / d j = chi / root
}

}  // namespace lpq

// See space_energy.h.
#include "shell/shape/space_energy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cleanup/corner_terms.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr Evaluation refused{0, EvalStatus::outside_domain};
// A corner is straight when the sine of its angle is less: far above rounding.
constexpr double least_sine = 1e-9;

using Quad = SpaceQuad;

struct Corners {
  Quad edge;   // edge[k] = p[k+1] - p[k]
  Quad area;   // edge[k-1] x edge[k]
  Vec3 twice;  // vector area of the quad, twice
  std::array<double, 4> squared;

  explicit Corners(const Quad& p) {
    for (int k = 0; k < 4; ++k) {
      edge[k] = p[(k + 1) & 3] - p[k];
      squared[k] = squared_length(edge[k]);
    }
    for (int k = 0; k < 4; ++k) area[k] = cross(edge[(k + 3) & 3], edge[k]);
    twice = area[0] + area[2];
  }
  double product(int k) const { return -dot(edge[(k + 3) & 3], edge[k]); }
  bool convex() const {
    const double whole = least_sine * least_sine * squared_length(twice);
    bool all = true;
    for (int k = 0; k < 4; ++k) {
      const double turn = dot(area[k], twice);
      all = all && turn > 0 && turn * turn > whole * squared[k] * squared[(k + 3) & 3];
    }
    return all;
  }
};

void scatter(const Quad& by_edge, Quad& gradient) {
  for (int k = 0; k < 4; ++k) {
    gradient[(k + 1) & 3] += by_edge[k];
    gradient[k] -= by_edge[k];
  }
}

/// Length term of one edge, by its squared length over h^2, or area term: value and derivative.
struct Term {
  double value = 0, slope = 0;
};

Term misfit_term(double s, double levels_off) {
  const double inverse = 1 / s, misfit = s + inverse - 2, damping = 1 / (1 + misfit / levels_off);
  return {misfit * damping, (1 - inverse * inverse) * damping * damping};
}

}  // namespace

Evaluation eta_energy(const Quad& p, double unit, Vec3 outside, const SpaceEtaOptions& options,
                      Quad& gradient) {
  const Corners corners(p);
  if (!corners.convex() || !(dot(corners.twice, outside) > 0)) return refused;
  std::array<double, 4> power, size, t;
  double total = 0;
  for (int k = 0; k < 4; ++k) {
    size[k] = length(corners.area[k]);
    const double lengths = std::sqrt(corners.squared[k] * corners.squared[(k + 3) & 3]);
    t[k] = corners.product(k) / (lengths + size[k]);
  }
  const std::array<double, 4> half = small_arc_tangents(t);
  for (int k = 0; k < 4; ++k) {
    const double deviation = -(4 / pi) * half[k];
    const double rounded = deviation * deviation + options.rounding * options.rounding;
    const double third = rounded * rounded * rounded;
    power[k] = third * deviation / size[k];
    total += rounded * third;
  }
  const double e = eighth_root(total), excess = std::max(0.0, e - options.floor_deviation);
  double sum = e + options.floor_weight * excess * excess;
  // d sum / d alpha_k = slope power_k |area_k|; alpha_k grows when edge k-1 turns left about the
  // normal of the corner, and shrinks when edge k does.
  const double slope = (2 / pi) * (1 + 2 * options.floor_weight * excess) * e / total;
  Quad by_edge;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) & 3;
    const Vec3 turn = power[next] * corners.area[next] - power[k] * corners.area[k];
    const double s = corners.squared[k] * unit;
    const Term term = misfit_term(s, s < 1 ? saturation_of_short : saturation);
    sum += options.size_weight * term.value;
    by_edge[k] = (slope / corners.squared[k]) * cross(turn, corners.edge[k]) +
                 (2 * options.size_weight * unit * term.slope) * corners.edge[k];
  }
  const double twice = length(corners.twice);
  const Term term = misfit_term(0.5 * twice * unit, saturation);
  sum += options.area_weight * term.value - options.cover_weight * twice;
  // twice = edge0 x edge1 + edge2 x edge3
  const double growth = 0.5 * options.area_weight * unit * term.slope - options.cover_weight;
  const Vec3 n = (growth / twice) * corners.twice;
  for (int k = 0; k < 4; k += 2) {
    by_edge[k] += cross(corners.edge[k + 1], n);
    by_edge[k + 1] += cross(n, corners.edge[k]);
  }
  scatter(by_edge, gradient);
  return {sum, EvalStatus::ok};
}

Evaluation mean_ratio_energy(const Quad& p, double unit, Vec3 outside,
                             const MeanRatioOptions& options, Quad& gradient) {
  const Corners corners(p);
  const double eps = options.epsilon;
  Quad by_edge{};
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const int b = (k + 3) & 3;
    const double l = (corners.squared[k] + corners.squared[b]) * unit;
    const double j = dot(corners.area[k], outside) * unit;
    if (eps == 0 && j <= least_corner) return refused;
    const MeanRatioTerm term = mean_ratio_term(l, j, options.size_weight, eps);
    sum += term.value;
    by_edge[k] +=
        unit * (term.by_l_twice * corners.edge[k] + term.by_j * cross(outside, corners.edge[b]));
    by_edge[b] +=
        unit * (term.by_l_twice * corners.edge[b] + term.by_j * cross(corners.edge[k], outside));
  }
  scatter(by_edge, gradient);
  return {sum, EvalStatus::ok};
}

double smallest_corner(const Quad& p, double unit, Vec3 outside) {
  const Corners corners(p);
  double least = dot(corners.area[0], outside);
  for (int k = 1; k < 4; ++k) least = std::min(least, dot(corners.area[k], outside));
  return least * unit;
}

bool is_strictly_convex(const Quad& p, Vec3 outside) {
  const Corners corners(p);
  return corners.convex() && dot(corners.twice, outside) > 0;
}

}  // namespace lpq

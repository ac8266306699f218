#include "cleanup/shape_energy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cleanup/corner_terms.h"
#include "field/field.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr Evaluation refused{0, EvalStatus::outside_domain};
// Slope of the size field at which the size terms count half, and the least they count.
constexpr double steep = 0.1, least_share = 0.4;

// A face's edges e[k] = p[k+1] - p[k] and what both energies need of them.
template <int N>
struct Corners {
  std::array<Vec2, N> edge;
  std::array<double, N> squared;

  Corners(const Face& face, std::span<const Vec2> points) {
    for (int k = 0; k < N; ++k) {
      edge[k] = points[face[(k + 1) % N]] - points[face[k]];
      squared[k] = squared_length(edge[k]);
    }
  }
  static constexpr int before(int k) { return (k + N - 1) % N; }
  double area(int k) const { return cross(edge[before(k)], edge[k]); }    // |e1||e2| sin
  double product(int k) const { return -dot(edge[before(k)], edge[k]); }  // |e1||e2| cos

  // Hands the derivative by edge k to its two ends.
  static void scatter(const Face& face, int k, Vec2 by_edge, std::span<Vec2> gradient) {
    gradient[face[(k + 1) % N]] += by_edge;
    gradient[face[k]] = gradient[face[k]] - by_edge;
  }
};

template <int N>
Evaluation mean_ratio_face(const Face& face, std::span<const Vec2> points, double unit,
                           const MeanRatioOptions& options, std::span<Vec2> gradient) {
  const Corners<N> corners(face, points);
  const double eps = options.epsilon;
  std::array<Vec2, N> by_edge{};
  double sum = 0;
  for (int k = 0; k < N; ++k) {
    const int b = Corners<N>::before(k);
    const double l = (corners.squared[k] + corners.squared[b]) * unit;
    const double j = corners.area(k) * unit;
    if (eps == 0 && j <= least_corner) return refused;
    const MeanRatioTerm term = mean_ratio_term(l, j, options.size_weight, eps);
    sum += term.value;
    by_edge[k] +=
        unit * (term.by_l_twice * corners.edge[k] + term.by_j * perpendicular(corners.edge[b]));
    by_edge[b] +=
        unit * (term.by_l_twice * corners.edge[b] - term.by_j * perpendicular(corners.edge[k]));
  }
  for (int k = 0; k < N; ++k) Corners<N>::scatter(face, k, by_edge[k], gradient);
  return {sum, EvalStatus::ok};
}

// The area term of a quad: value, and its derivative by twice the area.
struct AreaTerm {
  double value = 0, slope = 0;
};

AreaTerm area_term(double twice_area, double unit, double weight) {
  const double s = 0.5 * twice_area * unit, inverse = 1 / s;
  const double misfit = s + inverse - 2, damping = 1 / (1 + misfit / saturation);
  return {weight * misfit * damping,
          0.5 * weight * unit * (1 - inverse * inverse) * damping * damping};
}

// The direction term of one edge: value, and its derivative by the angle of the edge.
struct DirectionTerm {
  double value = 0, slope = 0;
};

DirectionTerm direction_term(Vec2 edge, double squared, Vec2 pull) {
  const Vec2 fourth = (1 / (squared * squared)) *
                      complex_product(complex_product(edge, edge), complex_product(edge, edge));
  const Vec2 turned = complex_product(fourth, conjugate(pull));
  return {length(pull) - turned.x, 4 * turned.y};
}

// The angles of a face: value, and its derivative by the angle at corner k, slope power[k].
template <int N>
struct AngleTerm {
  double value = 0, slope = 0;
  std::array<double, N> power;
};

template <int N>
AngleTerm<N> angle_term(const Corners<N>& corners, const std::array<double, N>& area,
                        const EtaEnergyOptions& options) {
  constexpr double target = N == 4 ? 0.0 : 1.0 / 3.0;  // 90 or 60 degrees, from 90, over 90
  std::array<double, N> t, rounded;
  for (int k = 0; k < N; ++k) {
    const double lengths = std::sqrt(corners.squared[k] * corners.squared[Corners<N>::before(k)]);
    t[k] = corners.product(k) / (lengths + area[k]);
  }
  std::array<double, N> deviation = small_arc_tangents(t);
  for (int k = 0; k < N; ++k) deviation[k] = target - (4 / pi) * deviation[k];
  const double rounding = options.rounding * options.rounding;
  for (int k = 0; k < N; ++k) rounded[k] = deviation[k] * deviation[k] + rounding;
  AngleTerm<N> term;
  for (int k = 0; k < N; ++k) {
    const double third = rounded[k] * rounded[k] * rounded[k];
    term.power[k] = third * deviation[k];
    rounded[k] *= third;
  }
  double total = 0;
  for (int k = 0; k < N; ++k) total += rounded[k];
  const double e = eighth_root(total), excess = std::max(0.0, e - options.floor_deviation);
  term.value = e + options.floor_weight * excess * excess;
  // An angle enters its deviation with factor 2 / pi.
  term.slope = (1 + 2 * options.floor_weight * excess) * (e / total) * (2 / pi);
  return term;
}

// The length terms of its edges: values, and derivatives by the edges, stretch[k] edge[k].
template <int N>
struct LengthTerms {
  std::array<double, N> value, stretch;
};

template <int N>
LengthTerms<N> length_terms(const Corners<N>& corners, const std::array<double, N>& inverse,
                            double unit, double weight) {
  LengthTerms<N> terms;
  for (int k = 0; k < N; ++k) {
    const double s = corners.squared[k] * unit, inverse_s = inverse[k] / unit;
    const double misfit = s + inverse_s - 2;
    const double damping = 1 / (1 + misfit / (s < 1 ? saturation_of_short : saturation));
    terms.value[k] = weight * misfit * damping;
    terms.stretch[k] = 2 * weight * unit * (1 - inverse_s * inverse_s) * damping * damping;
  }
  return terms;
}

template <int N>
Evaluation eta_face(const Face& face, std::span<const Vec2> points, double unit, double share,
                    Vec2 pull, const EtaEnergyOptions& options, std::span<Vec2> gradient) {
  const Corners<N> corners(face, points);
  std::array<double, N> area, inverse, turn;
  double least = corners.area(0);
  for (int k = 0; k < N; ++k) area[k] = corners.area(k);
  for (int k = 1; k < N; ++k) least = std::min(least, area[k]);
  if (!(least > 0)) return refused;
  for (int k = 0; k < N; ++k) inverse[k] = 1 / corners.squared[k];
  const AngleTerm<N> angles = angle_term<N>(corners, area, options);
  const LengthTerms<N> lengths =
      length_terms<N>(corners, inverse, unit, share * options.size_weight);
  double sum = angles.value;
  for (int k = 0; k < N; ++k)
    turn[k] = angles.slope * (angles.power[(k + 1) % N] - angles.power[k]) * inverse[k];
  for (int k = 0; k < N; ++k) sum += lengths.value[k];
  if (N == 4 && !(pull == Vec2{0, 0}))
    for (int k = 0; k < N; ++k) {
      const DirectionTerm term = direction_term(corners.edge[k], corners.squared[k], pull);
      sum += options.pull_weight * term.value;
      turn[k] += options.pull_weight * term.slope / corners.squared[k];
    }
  double growth = 0;
  if (N == 4 && options.area_weight > 0) {
    const AreaTerm term = area_term(area[1] + area[3], unit, share * options.area_weight);
    sum += term.value;
    growth = term.slope;
  }
  for (int k = 0; k < N; ++k) {
    Vec2 by_edge = turn[k] * perpendicular(corners.edge[k]) + lengths.stretch[k] * corners.edge[k];
    // Twice the area is e0 x e1 + e2 x e3.
    if (growth != 0)
      by_edge += (k % 2 == 0 ? -growth : growth) * perpendicular(corners.edge[k ^ 1]);
    Corners<N>::scatter(face, k, by_edge, gradient);
  }
  return {sum, EvalStatus::ok};
}

// A face laid out as its stretch makes it; the stretch is symmetric, so gradients come back by it.
template <class Kernel>
Evaluation of_stretched(const Face& face, std::span<const Vec2> points, Vec2 mu,
                        std::span<Vec2> gradient, Kernel&& kernel) {
  const int n = corner_count(face);
  std::array<Vec2, 4> laid_out, slope{};
  for (int k = 0; k < n; ++k) laid_out[k] = stretched(points[face[k]], mu);
  const Evaluation one = kernel(Face{0, 1, 2, n == 4 ? 3 : none}, laid_out, slope);
  for (int k = 0; k < n; ++k) gradient[face[k]] += stretched(slope[k], mu);
  return one;
}

// `kernel(f, face, points, gradient)`: of the one face.
template <class Kernel>
Evaluation sum_faces(std::span<const Face> faces, std::span<const Vec2> points,
                     std::span<const double> inverse_square, std::span<const Vec2> stretch,
                     std::span<Vec2> gradient, Kernel kernel) {
  double sum = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (inverse_square[f] == 0) continue;
    const auto of_face = [&](const Face& face, std::span<const Vec2> p, std::span<Vec2> g) {
      return kernel(f, face, p, g);
    };
    const Evaluation one = stretch.empty()
                               ? of_face(faces[f], points, gradient)
                               : of_stretched(faces[f], points, stretch[f], gradient, of_face);
    if (one.status != EvalStatus::ok) return one;
    sum += one.value;
  }
  return {sum, EvalStatus::ok};
}

template <int N>
double smallest_corner_of(const Face& face, std::span<const Vec2> points) {
  const Corners<N> corners(face, points);
  double least = corners.area(0);
  for (int k = 1; k < N; ++k) least = std::min(least, corners.area(k));
  return least;
}

}  // namespace

Evaluation mean_ratio_energy(std::span<const Face> faces, std::span<const Vec2> points,
                             std::span<const double> inverse_square,
                             const MeanRatioOptions& options, std::span<Vec2> gradient) {
  return sum_faces(faces, points, inverse_square, options.stretch, gradient,
                   [&](std::size_t f, const Face& face, auto p, auto g) {
                     return corner_count(face) == 4
                                ? mean_ratio_face<4>(face, p, inverse_square[f], options, g)
                                : mean_ratio_face<3>(face, p, inverse_square[f], options, g);
                   });
}

Evaluation eta_energy(std::span<const Face> faces, std::span<const Vec2> points,
                      std::span<const double> inverse_square, const EtaEnergyOptions& options,
                      std::span<Vec2> gradient, std::span<const Vec2> pull) {
  const auto share = [&](std::size_t f) {
    return options.size_share.empty() ? 1.0 : options.size_share[f];
  };
  return sum_faces(faces, points, inverse_square, options.stretch, gradient,
                   [&](std::size_t f, const Face& face, auto p, auto g) {
                     if (corner_count(face) == 3)
                       return eta_face<3>(face, p, inverse_square[f], share(f), {}, options, g);
                     const Vec2 z = pull.empty() ? Vec2{0, 0} : pull[f];
                     return eta_face<4>(face, p, inverse_square[f], share(f), z, options, g);
                   });
}

double share_at_slope(double slope) {
  const double ratio = slope / steep;
  return std::max(least_share, 1 / (1 + ratio * ratio));
}

double smallest_corner(std::span<const Face> faces, std::span<const Vec2> points,
                       std::span<const double> inverse_square) {
  double least = 1e300;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (inverse_square[f] == 0) continue;
    const double area = corner_count(faces[f]) == 4 ? smallest_corner_of<4>(faces[f], points)
                                                    : smallest_corner_of<3>(faces[f], points);
    least = std::min(least, area * inverse_square[f]);
  }
  return least;
}

}  // namespace lpq

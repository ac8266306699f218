// The two energies that move vertices, as kernels over flat arrays (value and gradient together):
//
//   mean ratio   sum over corners of l / (2 chi) + w (chi + 1/chi) / 2 with
//                  l   = (|e1|^2 + |e2|^2) / s^2
//                  J   = e1 x e2 / s^2
//                  chi = (J + sqrt(J^2 + eps^2)) / 2           [Escobar et al. 2003]
//                finite on tangled faces for eps > 0, so it can untangle; s is the face's own size;
//
//   eta          sum over faces of e + g max(0, e - e0)^2 plus a length term, with e the 8-norm of
//                the corners' angle deviations |2 alpha / pi - 1|: a smooth 1 - eta, with a soft
//                floor that pushes the worst faces harder. Length term: m / (1 + m / 16) with
//                m = s + 1/s - 2 of the squared edge length s over h^2, which is ln^2(s) to second
//                order without a logarithm, and bounded. Where quads must follow crosses z, a
//                direction term |z| - Re(u^4 conj z) for the direction u of every edge.
// Corner angles come from tan(phi / 2) = dot / (|e1||e2| + cross) and one polynomial, so only
// + - * / sqrt decide the bits. Triangles aim at 60 degrees. Cost: about 60 ns per face.
#pragma once

#include <cmath>
#include <span>

#include "mesh/quad_mesh.h"
#include "numerics/lbfgs.h"

namespace lpq {

struct MeanRatioOptions {
  double epsilon = 0;             // 0: faces must be convex, otherwise outside_domain
  double size_weight = 0.1;       // w
  std::span<const Vec2> stretch;  // #F  mu of the plane there (field/field.h); empty: 0
};

/// Untangling goes on by continuation [Escobar et al. 2003]: with an epsilon that grows with the
/// worst J, so that its corner still has a slope to climb, and shrinks from round to round, until
/// the smallest corner is untangled and epsilon 0. The numbers are ours, by experience.
inline constexpr double untangled_corner = 1e-3;  // J
inline constexpr double epsilon_shrink = 0.7;     // from round to round
inline constexpr double most_epsilon = 0.5;       // where s is the face's own size
inline double untangling_epsilon(double worst) {
  constexpr double squared_least = 0.01, growth = 0.5;
  return std::sqrt(squared_least + growth * worst * worst);
}

/// Rounding that lets a few iterations go far (1 - eta is a largest absolute value: without
/// rounding L-BFGS gets stuck where angles are right). For everything but the last smoothing.
inline constexpr double coarse_rounding = 0.03;

struct EtaEnergyOptions {
  double size_weight = 0.02;      // of the length term, per edge and side
  double area_weight = 0;         // of the area term of a quad
  double rounding = 1e-4;         // d counts as sqrt(d^2 + rounding^2): no kink at right angles
  double floor_deviation = 0.36;  // e0 = 1 - the eta below which the floor pushes
  double floor_weight = 100;      // g
  double pull_weight = 2;         // of the direction term, per edge and side
  std::span<const double> size_share;  // #F  factor of a face's size terms; empty: 1
  std::span<const Vec2> stretch;       // #F  mu of the plane there (field/field.h); empty: 0
};

/// The share of the size terms where the size field has this slope: lines of the mesh that keep to
/// a steep field have to end or to spread, so there shapes pay most for sizes.
double share_at_slope(double slope);

/// `inverse_square[f]` is 1/s^2 of the face; 0 leaves the face out. Adds to `gradient`.
Evaluation mean_ratio_energy(std::span<const Face> faces, std::span<const Vec2> points,
                             std::span<const double> inverse_square,
                             const MeanRatioOptions& options, std::span<Vec2> gradient);

/// outside_domain when a corner of a face that counts is not a left turn. `pull[f]`, if any, is a
/// z towards whose cross the edges of quad f turn, the firmer the longer it is.
Evaluation eta_energy(std::span<const Face> faces, std::span<const Vec2> points,
                      std::span<const double> inverse_square, const EtaEnergyOptions& options,
                      std::span<Vec2> gradient, std::span<const Vec2> pull = {});

/// Least J of all corners of the faces that count: the measure of how tangled they are.
double smallest_corner(std::span<const Face> faces, std::span<const Vec2> points,
                       std::span<const double> inverse_square);

}  // namespace lpq

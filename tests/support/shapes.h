// Named domains for tests, benchmarks and the paper's figures: outlines sampled evenly at size h,
// an even number of nodes on every loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/rng.h"
#include "domain/domain.h"

namespace lpq_test {

using lpq::DomainInput;
using lpq::Loop;
using lpq::Vec2;

inline DomainInput domain_of(std::vector<Loop> loops, double h = 0) {
  DomainInput input;
  input.regions.push_back({"", std::move(loops), {}});
  input.h = h;
  return input;
}

/// Corners joined by straight lines, each cut into equal pieces of about h; an even total.
inline Loop sampled_polygon(const std::vector<Vec2>& corners, double h) {
  const std::size_t n = corners.size();
  std::vector<int> pieces(n);
  int total = 0;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double side = lpq::distance(corners[i], corners[(i + 1) % n]);
    pieces[i] = std::max(1, static_cast<int>(std::lround(side / h)));
    total += pieces[i];
    if (side > lpq::distance(corners[longest], corners[(longest + 1) % n])) longest = i;
  }
  pieces[longest] += total % 2;
  Loop loop;
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < pieces[i]; ++k) {
      const double t = static_cast<double>(k) / pieces[i];
      loop.push_back(corners[i] + t * (corners[(i + 1) % n] - corners[i]));
    }
  return loop;
}

/// A closed curve of t in [0, 1), sampled evenly by arc length at about h; an even total.
template <class Curve>
Loop sampled_curve(Curve curve, double h) {
  constexpr int fine = 8192;
  std::vector<Vec2> points;
  std::vector<double> arc{0};
  for (int i = 0; i <= fine; ++i) {
    points.push_back(curve(static_cast<double>(i % fine) / fine));
    if (i > 0) arc.push_back(arc.back() + lpq::distance(points[i - 1], points[i]));
  }
  const int count = 2 * std::max(4, static_cast<int>(std::lround(arc.back() / h / 2)));
  Loop loop;
  for (int k = 0, j = 0; k < count; ++k) {
    const double s = arc.back() * k / count;
    while (arc[j + 1] < s) ++j;
    const double t = (s - arc[j]) / (arc[j + 1] - arc[j]);
    loop.push_back(points[j] + t * (points[j + 1] - points[j]));
  }
  return loop;
}

inline Loop circle(Vec2 centre, double radius, double h) {
  return sampled_curve(
      [=](double t) {
        const double a = 2 * std::numbers::pi * t;
        return centre + radius * Vec2{std::cos(a), std::sin(a)};
      },
      h);
}

inline DomainInput square(double side, double h) {
  return domain_of({sampled_polygon({{0, 0}, {side, 0}, {side, side}, {0, side}}, h)}, h);
}

inline DomainInput disc(double h) { return domain_of({circle({0, 0}, 0.6, h)}, h); }

inline DomainInput annulus(double h) {
  return domain_of({circle({0, 0}, 0.7, h), circle({0, 0}, 0.3, h)}, h);
}

inline DomainInput l_shape(double h) {
  return domain_of({sampled_polygon({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}}, h)},
                   h);
}

/// A 2 x 1 plate with an off-centre hole.
inline DomainInput plate_with_hole(double h) {
  return domain_of(
      {sampled_polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, h), circle({0.7, 0.45}, 0.2, h)}, h);
}

/// The outline of a car hood: four bulging sides (the kind of part of the paper's Figs. 19 to 23).
inline DomainInput hood(double h) {
  const auto outline = [](double t) {
    constexpr Vec2 corner[4] = {{-0.8, -0.5}, {0.8, -0.5}, {0.6, 0.5}, {-0.6, 0.5}};
    constexpr Vec2 bulge[4] = {{0, -0.18}, {0.1, 0}, {0, 0.1}, {-0.1, 0}};
    const int side = std::min(3, static_cast<int>(4 * t));
    const double u = 4 * t - side;
    return corner[side] + u * (corner[(side + 1) % 4] - corner[side]) +
           4 * u * (1 - u) * bulge[side];
  };
  return domain_of({sampled_curve(outline, h)}, h);
}

/// Interior points of an n x n grid on the unit square (boundary left out), each moved by up to
/// `jitter` cells: the starts of the paper's Fig. 12 have n = 11 and 81 points.
inline std::vector<Vec2> jittered_grid(int n, double jitter, std::uint64_t seed) {
  lpq::Rng rng(seed);
  std::vector<Vec2> points;
  const double h = 1.0 / (n - 1);
  for (int j = 1; j + 1 < n; ++j)
    for (int i = 1; i + 1 < n; ++i) {
      const double dx = rng.between(-jitter, jitter), dy = rng.between(-jitter, jitter);
      points.push_back(
          {h * std::clamp(i + dx, 0.3, n - 1.3), h * std::clamp(j + dy, 0.3, n - 1.3)});
    }
  return points;
}

}  // namespace lpq_test

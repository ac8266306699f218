// Domains with known crosses for the tests of the fields and seeds.
#pragma once

#include <cmath>
#include <vector>

#include "support/field_boundary.h"

namespace lpq::test {

inline std::vector<Vec2> rectangle(Vec2 low, Vec2 high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

inline std::vector<Vec2> turned_by(std::vector<Vec2> loop, Vec2 unit) {
  for (Vec2& p : loop) p = complex_product(p, unit);
  return loop;
}

inline std::vector<Vec2> regular_polygon(int n, double radius) { return circle({0, 0}, radius, n); }

inline BoundaryMesh square_boundary(double h) {
  return boundary_of({divided(rectangle({0, 0}, {1, 1}), h)});
}

inline BoundaryMesh disc_boundary(int n) { return boundary_of({circle({0.5, 0.5}, 0.5, n)}); }

inline BoundaryMesh annulus_boundary(int outer, int inner) {
  return boundary_of({circle({0.5, 0.5}, 0.5, outer), reversed(circle({0.5, 0.5}, 0.2, inner))});
}

inline BoundaryMesh plate_with_hole(double h, int hole) {
  return boundary_of(
      {divided(rectangle({0, 0}, {1, 0.8}), h), reversed(circle({0.45, 0.4}, 0.18, hole))});
}

inline BoundaryMesh l_shape(double h) {
  return boundary_of({divided({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}}, h)});
}

/// A saw whose edges shrink from 1/2 to 2^-levels: spacings over many orders of magnitude.
inline BoundaryMesh graded_saw(int levels) {
  std::vector<Vec2> loop{{0, 0}, {1, 0}, {1, 1}};
  double x = 1;
  for (int i = 0; i < levels; ++i) {
    x *= 0.5;
    loop.push_back({x, i % 2 == 0 ? 1 - 0.5 * x : 1.0});
  }
  loop.push_back({0, 1});
  return boundary_of({loop});
}

}  // namespace lpq::test

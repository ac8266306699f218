// Boundary meshes for tests of the fields and seeds, made directly from loops in the unit frame.
#pragma once

#include <cmath>
#include <vector>

#include "domain/boundary.h"

namespace lpq::test {

/// Outer loops counter-clockwise, holes clockwise: the domain lies on the left of every edge.
inline BoundaryMesh boundary_of(const std::vector<std::vector<Vec2>>& loops) {
  BoundaryMesh b;
  for (const auto& loop : loops) {
    const Index first = static_cast<Index>(b.points.size()), n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) {
      const Vec2 p = loop[i];
      b.points.push_back(p);
      b.edges.push_back({first + i, first + (i + 1) % n, 0, none, none, 0, 0, i});
      b.spacing.push_back(0.5 *
                          (distance(loop[(i + n - 1) % n], p) + distance(p, loop[(i + 1) % n])));
    }
  }
  b.world = b.points;
  for (Index i = 0; i < static_cast<Index>(b.points.size()); ++i) {
    b.source.push_back(i);
    b.output_rank.push_back(i);
  }
  return b;
}

/// The corners joined by edges of about length h.
inline std::vector<Vec2> divided(const std::vector<Vec2>& corners, double h) {
  std::vector<Vec2> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::floor(distance(a, b) / h + 0.5)));
    for (int k = 0; k < n; ++k) loop.push_back(a + (static_cast<double>(k) / n) * (b - a));
  }
  return loop;
}

/// n points counter-clockwise on a circle.
inline std::vector<Vec2> circle(Vec2 centre, double radius, int n) {
  std::vector<Vec2> loop;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * 3.14159265358979323846 * i / n;
    loop.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return loop;
}

inline std::vector<Vec2> reversed(std::vector<Vec2> loop) { return {loop.rbegin(), loop.rend()}; }

inline BoundaryMesh scaled(BoundaryMesh b, double s) {
  for (Vec2& p : b.points) p = s * p;
  for (Vec2& p : b.world) p = s * p;
  for (double& x : b.spacing) x *= s;
  return b;
}

}  // namespace lpq::test

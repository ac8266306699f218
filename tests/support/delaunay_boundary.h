// Boundary meshes by hand, without going through a Domain.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "domain/boundary.h"
#include "support/point_sets.h"

namespace lpq_test {

using lpq::BoundaryMesh;
using lpq::none;
using Loop = std::vector<Vec2>;

inline double twice_area(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  }
  return sum;
}

inline void add_segment(BoundaryMesh& boundary, Index a, Index b, Index left, Index right) {
  lpq::Segment segment;
  segment.a = a;
  segment.b = b;
  segment.left = left;
  segment.right = right;
  boundary.edges.push_back(segment);
}

/// A closed loop with `inside` on its left; its points are appended.
inline void add_loop(BoundaryMesh& boundary, const Loop& loop, Index left, Index right) {
  const Index first = static_cast<Index>(boundary.points.size());
  const Index count = static_cast<Index>(loop.size());
  boundary.points.insert(boundary.points.end(), loop.begin(), loop.end());
  for (Index i = 0; i < count; ++i) {
    add_segment(boundary, first + i, first + (i + 1) % count, left, right);
  }
}

/// An open polyline inside region 0, a wall on both sides.
inline void add_polyline(BoundaryMesh& boundary, const Loop& points) {
  const Index first = static_cast<Index>(boundary.points.size());
  boundary.points.insert(boundary.points.end(), points.begin(), points.end());
  for (Index i = 0; i + 1 < static_cast<Index>(points.size()); ++i) {
    add_segment(boundary, first + i, first + i + 1, 0, 0);
  }
}

/// The first loop is the outer one; any orientation is accepted. Region 0 everywhere.
inline BoundaryMesh boundary_of(std::vector<Loop> loops) {
  BoundaryMesh boundary;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if ((twice_area(loops[i]) > 0) != (i == 0)) std::reverse(loops[i].begin(), loops[i].end());
    add_loop(boundary, loops[i], 0, none);
  }
  return boundary;
}

inline Loop rectangle(Vec2 lo, Vec2 hi) { return {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}}; }

/// A closed curve around the centre with radius r(angle), n nodes.
template <class Radius>
Loop star_curve(Vec2 centre, int n, const Radius& radius) {
  Loop loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    loop.push_back(centre + radius(angle) * Vec2{std::cos(angle), std::sin(angle)});
  }
  return loop;
}

/// A nonconvex domain with two holes; feature size about 0.2.
inline BoundaryMesh flower_with_holes(int n = 120) {
  return boundary_of(
      {star_curve({0, 0}, n, [](double a) { return 1 + 0.3 * std::cos(5 * a); }),
       star_curve({0.3, 0.2}, n / 4, [](double) { return 0.2; }),
       star_curve({-0.35, -0.1}, n / 4, [](double a) { return 0.2 + 0.05 * std::cos(3 * a); })});
}

/// A thin double spiral of about 2 n nodes: neighbours in the plane are far along the boundary.
inline BoundaryMesh spiral(int n, double turns = 12) {
  Loop loop;
  const auto arm = [&](int i, double shift) {
    const double s = static_cast<double>(i) / n, angle = 2 * 3.14159265358979323846 * turns * s;
    const double radius = 0.1 + (s * turns + shift) / (turns + 1);
    loop.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  };
  for (int i = 0; i <= n; ++i) arm(i, 0.0);
  for (int i = n; i >= 0; --i) arm(i, 0.4);
  return boundary_of({loop});
}

}  // namespace lpq_test

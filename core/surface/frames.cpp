#include "surface/frames.h"

#include <algorithm>
#include <cmath>

namespace lpq {
namespace {

Vec3 unit(Vec3 a) {
  // Scaled first: squares of tiny lengths underflow.
  const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (largest == 0) return {0, 0, 0};
  const Vec3 b = (1 / largest) * a;
  return (1 / length(b)) * b;
}

// Across the smallest component, so that the product is not small.
Vec3 any_perpendicular(Vec3 x) {
  const double ax = std::abs(x.x), ay = std::abs(x.y), az = std::abs(x.z);
  if (ax <= ay && ax <= az) return unit(cross(x, {1, 0, 0}));
  return unit(ay <= az ? cross(x, {0, 1, 0}) : cross(x, {0, 0, 1}));
}

Vec3 first_axis(Vec3 ab, Vec3 ac) {
  const Vec3 x = unit(ab);
  if (!(x == Vec3{0, 0, 0})) return x;
  const Vec3 other = unit(ac);
  return other == Vec3{0, 0, 0} ? Vec3{1, 0, 0} : other;
}

}  // namespace

TriangleLayout layout_of(const SurfaceMesh& mesh, Index t) {
  const auto [a, b, c] = mesh.triangles[t];
  const Vec3 ab = mesh.points[b] - mesh.points[a], ac = mesh.points[c] - mesh.points[a];
  const Vec3 x = first_axis(ab, ac);
  const Vec2 to_b{length(ab), 0}, to_c{dot(ac, x), length(cross(x, ac))};
  return {{to_b, to_c - to_b, -to_c}, 0.5 * to_b.x * to_c.y};
}

TriangleAxes axes_of(const SurfaceMesh& mesh, Index t) {
  const auto [a, b, c] = mesh.triangles[t];
  const Vec3 ab = mesh.points[b] - mesh.points[a], ac = mesh.points[c] - mesh.points[a];
  const Vec3 x = first_axis(ab, ac);
  Vec3 y = ac - dot(ac, x) * x;
  y = unit(y - dot(y, x) * x);
  if (y == Vec3{0, 0, 0}) y = any_perpendicular(x);
  return {x, y, cross(x, y)};
}

}  // namespace lpq

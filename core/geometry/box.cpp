#include "geometry/box.h"

namespace lpq {

Box box_of(Vec2 a, Vec2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

Box box_of(std::span<const Vec2> points) {
  Box box{points.front(), points.front()};
  for (const Vec2 p : points) extend(box, p);
  return box;
}

double squared_distance(const Box& a, const Box& b) {
  const double dx = std::max({0.0, a.lo.x - b.hi.x, b.lo.x - a.hi.x});
  const double dy = std::max({0.0, a.lo.y - b.hi.y, b.lo.y - a.hi.y});
  return dx * dx + dy * dy;
}

double bounding_diagonal(std::span<const Vec3> points) {
  if (points.empty()) return 0;
  Box3 box{points[0], points[0]};
  for (const Vec3 p : points) extend(box, p);
  return diagonal(box);
}

}  // namespace lpq

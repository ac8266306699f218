// All signs come from orient2d; along a common line, points are compared lexicographically, which
// is monotone on every line.
#include "geometry/segment.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace lpq {
namespace {

bool boxes_apart(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
         std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
}

Meeting meet_on_a_line(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (b < a) std::swap(a, b);
  if (d < c) std::swap(c, d);
  const Vec2 lo = a < c ? c : a, hi = b < d ? b : d;
  if (lo < hi) return Meeting::overlapping;
  return lo == hi ? Meeting::touching : Meeting::apart;
}

}  // namespace

Meeting meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (boxes_apart(a, b, c, d)) return Meeting::apart;
  const int ab_c = orient2d(a, b, c), ab_d = orient2d(a, b, d);
  if (ab_c * ab_d > 0) return Meeting::apart;
  if (ab_c == 0 && ab_d == 0) return meet_on_a_line(a, b, c, d);
  const int cd_a = orient2d(c, d, a), cd_b = orient2d(c, d, b);
  if (cd_a * cd_b > 0) return Meeting::apart;
  if (ab_c * ab_d < 0 && cd_a * cd_b < 0) return Meeting::crossing;
  return Meeting::touching;
}

bool same_direction(Vec2 from, Vec2 p, Vec2 q) {
  return orient2d(from, p, q) == 0 && (p < from) == (q < from);
}

bool on_segment(Vec2 p, Vec2 a, Vec2 b) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y) && orient2d(a, b, p) == 0;
}

Vec2 crossing_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double denominator = cross(b - a, d - c);
  if (denominator == 0) return closest_point(c, a, b);
  const double t = std::clamp(cross(c - a, d - c) / denominator, 0.0, 1.0);
  return a + t * (b - a);
}

Vec2 closest_point(Vec2 p, Vec2 a, Vec2 b) {
  const double l2 = squared_length(b - a);
  if (l2 == 0) return a;
  const double t = dot(p - a, b - a) / l2;
  if (t <= 0) return a;
  if (t >= 1) return b;
  return a + t * (b - a);
}

}  // namespace lpq

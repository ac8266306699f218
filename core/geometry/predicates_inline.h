// The two predicates that decide topology, as exact as in geometry/predicates.h, with their
// floating filters inline, for the loops that ask millions of times. The filter compares the
// rounded determinant with Shewchuk's forward error bound; only when the bound cannot tell is the
// exact function called.
#pragma once

#include "geometry/vec.h"

namespace lpq {

/// The signs by exact arithmetic, without a filter in front.
int orient2d_exact(Vec2 a, Vec2 b, Vec2 c);
int in_circle_exact(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

namespace filter {
inline constexpr double epsilon = 0x1p-53;  // half the distance from 1 to the next double
// [Shewchuk 1997], Table in section 4.4 (constants "A").
inline constexpr double orient_bound = (3.0 + 16.0 * epsilon) * epsilon;
inline constexpr double circle_bound = (10.0 + 96.0 * epsilon) * epsilon;
}  // namespace filter

inline int orient2d_inline(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = filter::orient_bound * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return orient2d_exact(a, b, c);
}

/// For counter-clockwise a, b, c: +1 if d is strictly inside their circle, -1 outside, 0
/// cocircular.
inline int in_circle_inline(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double bxcy = bx * cy, bycx = by * cx;
  const double cxay = cx * ay, cyax = cy * ax;
  const double axby = ax * by, aybx = ay * bx;
  const double a2 = ax * ax + ay * ay;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double det = a2 * (bxcy - bycx) + b2 * (cxay - cyax) + c2 * (axby - aybx);
  const double permanent = a2 * (std::abs(bxcy) + std::abs(bycx)) +
                           b2 * (std::abs(cxay) + std::abs(cyax)) +
                           c2 * (std::abs(axby) + std::abs(aybx));
  const double bound = filter::circle_bound * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return in_circle_exact(a, b, c, d);
}

}  // namespace lpq

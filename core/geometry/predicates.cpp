// Orientation and in-circle signs in three steps of growing cost: the floating filter (inline), for
// in-circle a second filter in double-double arithmetic (points sampled on a circle defeat the
// first one systematically, but hardly ever the second), and exact expansions [Shewchuk 1997].
// Invariant: every step returns the exact sign or passes on. The steps grow dearer quickly.
#include "geometry/predicates.h"

#include "geometry/expansion.h"
#include "geometry/predicates_inline.h"

namespace lpq {
namespace {

using exact::Expansion;
using exact::Pair;

Expansion<2> difference(double a, double b) { return Expansion<2>(exact::two_difference(a, b)); }

// Double-double arithmetic; each operation errs by at most 2^-101 of the sum of the absolute
// values of its terms.
Pair add(Pair a, Pair b) {
  const Pair s = exact::two_sum(a.hi, b.hi);
  return exact::fast_two_sum(s.hi, s.lo + (a.lo + b.lo));
}

Pair multiply(Pair a, Pair b) {
  const Pair p = exact::two_product(a.hi, b.hi);
  return exact::fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

Pair cross_of(Pair ax, Pair ay, Pair bx, Pair by) {
  return add(multiply(ax, by), multiply({-ay.hi, -ay.lo}, bx));
}

double cross_magnitude(Pair ax, Pair ay, Pair bx, Pair by) {
  return std::abs(ax.hi * by.hi) + std::abs(ay.hi * bx.hi);
}

// Sign of the in-circle determinant in double-double, 0 if it cannot tell. The determinant has
// depth five, so its error is below 2^-98 of the permanent; the bound keeps a factor of four.
int in_circle_double_double(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Pair ax = exact::two_difference(a.x, d.x), ay = exact::two_difference(a.y, d.y);
  const Pair bx = exact::two_difference(b.x, d.x), by = exact::two_difference(b.y, d.y);
  const Pair cx = exact::two_difference(c.x, d.x), cy = exact::two_difference(c.y, d.y);
  const Pair a2 = add(multiply(ax, ax), multiply(ay, ay));
  const Pair b2 = add(multiply(bx, bx), multiply(by, by));
  const Pair c2 = add(multiply(cx, cx), multiply(cy, cy));
  const Pair det =
      add(add(multiply(a2, cross_of(bx, by, cx, cy)), multiply(b2, cross_of(cx, cy, ax, ay))),
          multiply(c2, cross_of(ax, ay, bx, by)));
  const double permanent = a2.hi * cross_magnitude(bx, by, cx, cy) +
                           b2.hi * cross_magnitude(cx, cy, ax, ay) +
                           c2.hi * cross_magnitude(ax, ay, bx, by);
  const double bound = 0x1p-96 * permanent;
  return det.hi > bound ? 1 : (det.hi < -bound ? -1 : 0);
}

}  // namespace

int orient2d_exact(Vec2 a, Vec2 b, Vec2 c) {
  const auto ax = difference(a.x, c.x), ay = difference(a.y, c.y);
  const auto bx = difference(b.x, c.x), by = difference(b.y, c.y);
  return (ax * by - ay * bx).sign();
}

int in_circle_exact(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (const int sign = in_circle_double_double(a, b, c, d); sign != 0) return sign;
  const auto ax = difference(a.x, d.x), ay = difference(a.y, d.y);
  const auto bx = difference(b.x, d.x), by = difference(b.y, d.y);
  const auto cx = difference(c.x, d.x), cy = difference(c.y, d.y);
  const auto term = [](const auto& px, const auto& py, const auto& qx, const auto& qy,
                       const auto& rx,
                       const auto& ry) { return (px * px + py * py) * (qx * ry - qy * rx); };
  return (term(ax, ay, bx, by, cx, cy) + term(bx, by, cx, cy, ax, ay) +
          term(cx, cy, ax, ay, bx, by))
      .sign();
}

int orient2d(Vec2 a, Vec2 b, Vec2 c) { return orient2d_inline(a, b, c); }

}  // namespace lpq

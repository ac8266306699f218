#include "geometry/frame.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"

namespace lpq {
namespace {

// A shift that is exact for all values of [lo, hi]: lo itself when both are of one sign and within
// a factor of two, otherwise none (then |lo|, |hi| are at most of the size of the extent anyway).
double exact_shift(double lo, double hi) {
  const double small = std::min(std::abs(lo), std::abs(hi));
  const double large = std::max(std::abs(lo), std::abs(hi));
  return (lo > 0) == (hi > 0) && large <= 2 * small ? lo : 0.0;
}

}  // namespace

UnitFrame fit_frame(std::span<const Vec2> points) {
  UnitFrame frame;
  if (points.empty()) return frame;
  const Box box = box_of(points);
  frame.shift = {exact_shift(box.lo.x, box.hi.x), exact_shift(box.lo.y, box.hi.y)};
  const double extent = longer_side(box);
  if (extent > 0 && std::isfinite(extent)) {
    int exponent = 0;
    std::frexp(extent, &exponent);
    frame.scale = std::ldexp(1.0, -exponent);
  }
  return frame;
}

}  // namespace lpq

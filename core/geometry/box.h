// Boxes with sides along the axes.
#pragma once

#include <algorithm>
#include <span>

#include "geometry/vec.h"

namespace lpq {

struct Box {
  Vec2 lo, hi;
};

Box box_of(Vec2 a, Vec2 b);

/// Of at least one point.
Box box_of(std::span<const Vec2> points);

inline bool overlap(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

inline double longer_side(const Box& box) {
  return std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
}

double squared_distance(const Box& a, const Box& b);

}  // namespace lpq

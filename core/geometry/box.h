// Boxes with sides along the axes.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "geometry/vec.h"
#include "geometry/vec3.h"

namespace lpq {

struct Box {
  Vec2 lo, hi;
};

Box box_of(Vec2 a, Vec2 b);

/// Of at least one point.
Box box_of(std::span<const Vec2> points);

/// A box that contains nothing, to be extended.
inline Box empty_box() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity}, {-infinity, -infinity}};
}

inline void extend(Box& box, Vec2 p) {
  box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y)};
  box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y)};
}

inline bool overlap(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

inline double longer_side(const Box& box) {
  return std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
}

inline double diagonal(const Box& box) { return length(box.hi - box.lo); }

double squared_distance(const Box& a, const Box& b);

/// In space; at first it contains nothing.
struct Box3 {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity};
};

inline void extend(Box3& box, Vec3 p) {
  box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
  box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
}

inline void extend(Box3& box, const Box3& other) {
  extend(box, other.lo);
  extend(box, other.hi);
}

inline bool overlap(const Box3& a, const Box3& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
         a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

inline double squared_distance(const Box3& box, Vec3 p) {
  return squared_length({std::max({0.0, box.lo.x - p.x, p.x - box.hi.x}),
                         std::max({0.0, box.lo.y - p.y, p.y - box.hi.y}),
                         std::max({0.0, box.lo.z - p.z, p.z - box.hi.z})});
}

inline bool is_empty(const Box3& box) { return box.lo.x > box.hi.x; }

inline double diagonal(const Box3& box) { return length(box.hi - box.lo); }

/// Length of the diagonal of the box about the points; 0 without any.
double bounding_diagonal(std::span<const Vec3> points);

}  // namespace lpq

// How two closed segments lie to each other, decided exactly, and distances to segments, rounded.
#pragma once

#include <algorithm>

#include "geometry/vec.h"
#include "geometry/vec3.h"

namespace lpq {

enum class Meeting {
  apart,
  crossing,     // in one point interior to both
  touching,     // in one point that is an end of at least one of them
  overlapping,  // in more than one point (collinear)
};

/// Exact. Requires a != b and c != d.
Meeting meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Whether p and q, both other than `from`, lie in the same direction from it: the segments to them
/// lie on each other. Exact.
bool same_direction(Vec2 from, Vec2 p, Vec2 q);

/// True if p lies on the closed segment, exactly.
bool on_segment(Vec2 p, Vec2 a, Vec2 b);

/// Where the lines of two crossing segments meet, rounded.
Vec2 crossing_point(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// The point of the closed segment nearest to p, rounded.
Vec2 closest_point(Vec2 p, Vec2 a, Vec2 b);

/// How far along from a to b the point of the closed segment nearest to p lies, 0 to 1; 0 where a
/// is b. In the plane and in space.
template <class Vec>
double share_along(Vec p, Vec a, Vec b) {
  const Vec along = b - a;
  const double whole = squared_length(along);
  return whole > 0 ? std::clamp(dot(p - a, along) / whole, 0.0, 1.0) : 0;
}

/// Squared distance of p from the closed segment. Rounded, unlike closest_point() at the end b,
/// too.
template <class Vec>
double squared_distance_to_segment(Vec p, Vec a, Vec b) {
  return squared_length(p - (a + share_along(p, a, b) * (b - a)));
}

}  // namespace lpq

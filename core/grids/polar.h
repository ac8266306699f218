// The plane round a point as a strip: logarithms, which keep angles.
#pragma once

#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

/// (log r, theta) about a centre, theta in (-pi, pi]. The point is not the centre.
Vec2 logarithm_about(Vec2 centre, Vec2 p);

/// Angles leap on the ray to the left of the centre: 1 where the straight way from v to w crosses
/// it downwards, -1 upwards, else 0.
Index sheets_between(Vec2 v, Vec2 w, Vec2 centre);

/// A closed line in the strip, without leaps.
struct LineAbout {
  std::vector<Vec2> points;   // (log r, theta)
  std::vector<Index> sheets;  // #points  rounds by which theta is off (-pi, pi]
  Index rounds = 0;           // about the centre, to the left
};

/// Empty if one of the points is the centre.
LineAbout line_about(Vec2 centre, const std::vector<Vec2>& points);

}  // namespace lpq

// Closed polygons given by their corners (the first is not repeated at the end).
#pragma once

#include <span>

#include "geometry/vec.h"

namespace lpq {

/// Positive for counter-clockwise; rounded.
double signed_area(std::span<const Vec2> polygon);

/// The exact sign of the signed area; 0 exactly when the polygon encloses nothing in total.
int orientation(std::span<const Vec2> polygon);

enum class Side { outside, boundary, inside };

/// Even-odd rule, exact.
Side locate(Vec2 p, std::span<const Vec2> polygon);

}  // namespace lpq

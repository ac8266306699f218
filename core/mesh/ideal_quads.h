// How many quads fit an angle: what the matching, the clean-up and grids want at a boundary.
#pragma once

#include "base/index.h"

namespace lpq {

/// Quads that fit best between two walls at an angle, radians in (0, 2 pi]: k while the angle is at
/// most 180 k (k + 1) / (2 k + 1) degrees, where k corners deviate from 90 degrees as much, in
/// ratio, as k + 1 do: switches at 120, 216, 308.6 degrees.
Index ideal_quads(double angle);

/// The same as a number that grows steadily with the angle: k at 90 k degrees, k + 1/2 where k + 1
/// quads become better than k, linear between.
double fitting_quads(double angle);

/// Of an inner angle between two walls, radians: is it one of those in a hollow bend of few edges,
/// 213 to 244 degrees, where two quads (of at most 122 degrees) are nearly as good as three (of at
/// least 71)?
bool is_hollow_bend(double angle);

/// Such an angle between two others: the vertex may hold two quads or three.
bool is_in_hollow_bend(double before, double angle, double after);

}  // namespace lpq

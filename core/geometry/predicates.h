// The exact sign of an orientation, which decides topology: a floating filter, then expansion
// arithmetic [Shewchuk 1997]. Exact for all finite inputs whose products neither overflow nor
// underflow, which the unit frame (geometry/frame.h) guarantees.
#pragma once

#include "geometry/vec.h"

namespace lpq {

/// +1 if a, b, c turn left (counter-clockwise), -1 if right, 0 if exactly collinear.
int orient2d(Vec2 a, Vec2 b, Vec2 c);

}  // namespace lpq

// Places all over a triangle, however narrow it is.
#pragma once

#include <array>

#include "base/function_ref.h"
#include "base/index.h"
#include "geometry/vec3.h"

namespace lpq {

/// Barycentric coordinates of places no more than about 1.4 `step` apart (1000 of them along a side
/// at most), on chords across the longest side, and the area that each stands for. A needle lower
/// than half a step has fewer of them, 4 for the square of a step: those of a triangle's `number`
/// lie elsewhere than those of the next. Cost: their number, 1 at least; none of a triangle without
/// area.
void visit_places(const std::array<Vec3, 3>& corners, double step, Index number,
                  FunctionRef<void(const std::array<double, 3>& weight, double area)> visit);

}  // namespace lpq

// The unit frame: all geometry is done near the unit square, so that thresholds are dimensionless
// and nothing depends on the unit of length. The map is a power-of-two scale and a shift chosen so
// that it is EXACT on every input point: a subtraction x - s is exact when x and s lie within a
// factor of two of each other (Sterbenz), and no shift is made otherwise.
#pragma once

#include <span>

#include "geometry/vec.h"

namespace lpq {

struct UnitFrame {
  Vec2 shift;        // in the caller's units
  double scale = 1;  // power of two; frame = (world - shift) * scale

  Vec2 to_frame(Vec2 world) const {
    return {(world.x - shift.x) * scale, (world.y - shift.y) * scale};
  }
  /// Rounds to the nearest double in the caller's units.
  Vec2 to_world(Vec2 frame) const { return {frame.x / scale + shift.x, frame.y / scale + shift.y}; }
  /// The nearest frame point that the caller's coordinates can represent.
  Vec2 snap(Vec2 frame) const { return to_frame(to_world(frame)); }
  double length_to_frame(double world) const { return world * scale; }
  double length_to_world(double frame) const { return frame / scale; }
};

/// The frame of a set of finite points; extent 2^-1 .. 1 after scaling.
UnitFrame fit_frame(std::span<const Vec2> points);

}  // namespace lpq

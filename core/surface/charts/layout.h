// Charts side by side in one square, as textures want them.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"
#include "surface/charts/charts.h"

namespace lpq {

struct AtlasLayout {
  std::vector<Vec2> shift;  // #charts
  double side = 1;          // length of a side of the square, in the units of the surface
  /// A point of a chart's plane in the unit square.
  Vec2 place(Index chart, Vec2 p) const { return (1 / side) * (p + shift[chart]); }
};

/// Boxes of the charts in rows, the highest first, none turned or made larger than another, with a
/// gap around each that is 1/512 of the side or more. Cost O(#points + #charts log #charts).
AtlasLayout lay_out(std::span<const Chart> charts);

}  // namespace lpq

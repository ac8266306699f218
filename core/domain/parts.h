// The domain cut along everything that the mesh keeps: a region is one part, or several where
// polylines cut it from side to side. Quads never cross a segment, so counts of boundary edges
// must be even for every part, not only for every region.
#pragma once

#include <span>
#include <vector>

#include "domain/domain.h"

namespace lpq {

struct Parts {
  std::vector<Segment> segments;  // as given, but left and right are parts
  std::vector<Index> region;      // #parts

  Index count() const { return static_cast<Index>(region.size()); }
};

/// Requires a judged domain's segments: none cross, all have their sides. O(n log n).
Parts find_parts(std::span<const Vec2> points, std::span<const Segment> segments);

}  // namespace lpq

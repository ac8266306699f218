// Lines that end on other lines.
#pragma once

#include "io/domain/line_work.h"

namespace lpq {

struct Landings {
  Index count = 0;  // points at which an edge was divided
  double farthest = 0;
  Vec2 farthest_at;
};

/// Divides edges at the loose points that lie on them: exactly, or within `tolerance` on the
/// nearest edge or the curve it stands for, unless an edge joins the point to one of its ends.
/// Lines that run along each other are left for the door to judge, but for closed outlines side by
/// side: corners within `tolerance` of the straight edge of a neighbour divide it. Requires points
/// without duplicates. Cost O(n log n).
Landings divide_at_landings(LineWork& lines, double tolerance);

/// #points  whether each lies on an edge, exactly. Cost O((#edges + #points) log n).
std::vector<char> points_on_edges(const LineWork& lines, std::span<const Vec2> points);

}  // namespace lpq

// The last check of the 1D mesh: rounding the nodes may not have made edges meet.
#pragma once

#include <span>
#include <vector>

#include "domain/domain.h"

namespace lpq {

/// Edges that meet another one other than in a common end. Exact, about n log n.
std::vector<Index> meeting_edges(std::span<const Vec2> points, std::span<const Segment> edges);

}  // namespace lpq

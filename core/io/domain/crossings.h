// Lines that cross, touch or run along each other, and what divides them there.
#pragma once

#include <optional>
#include <vector>

#include "io/domain/line_work.h"

namespace lpq {

struct Crossing {
  Index edge = none, other = none;  // edge < other
};

/// Pairs of edges that meet other than at an end of both, exactly, or with an end of one within
/// `tolerance` of the other; edges between the same two places are no pair. Cost about n log n and
/// the pairs. Nothing: more than a million pairs.
std::optional<std::vector<Crossing>> find_crossings(const LineWork& lines, double tolerance = 0);

/// Divides edges where they meet, so that they share end points only, and makes points at one place
/// one; points within `tolerance`, from each other and from edges, count as there. Edges keep their
/// directions, those without length vanish. False where rounded crossings lead to new ones again
/// and again, or there are more than a million.
bool divide_at_crossings(LineWork& lines, double tolerance);

}  // namespace lpq

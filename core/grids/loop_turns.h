// Which way the edges of a border run on a lattice: where it turns, such that it comes back.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

/// Directions (lattice_step) of the edges of a simple polygon, the domain on its left, edge k from
/// points[k] to points[k + 1]: the line closes on the lattice and turns once in all, as it does in
/// the plane. Of such ways the one that costs least: for quads at the nodes that do not fit
/// (fitting_quads; one at a turn to the left, two straight on, three at a turn to the right), and
/// for edges that are off their directions in the plane. `axis`: direction 0 there, radians. Empty
/// if no way near the cheapest one closes, or if the polygon has more than 4000 edges. Cost
/// O(#points), times up to 5000 where the cheapest way does not close.
std::vector<Index> loop_turns(std::span<const Vec2> points, double axis);

/// The cheapest way of all, whether or not it closes; not empty for up to 4000 edges. Cost
/// O(#points).
std::vector<Index> open_turns(std::span<const Vec2> points, double axis);

/// As loop_turns for a line that goes on and on: point k again, `period` further. It ends as many
/// rows above its start as is wanted, or as comes, and in its column; direction 0 is that of the x
/// axis.
std::vector<Index> line_turns(std::span<const Vec2> points, Vec2 period, std::optional<Index> rows);

}  // namespace lpq

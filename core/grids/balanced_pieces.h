// A refined boundary with counts that a grid can have.
#pragma once

#include <vector>

#include "domain/boundary.h"

namespace lpq {

/// How many pieces the segments of a refined boundary should have, #S: near to what is wanted, but
/// with as many edges on opposite sides of every loop [WWBB96], as its cheapest way on the lattice
/// has them (loop_turns.h), where they are about as long; of holes without four clear corners the
/// number is even. Rings have as many outside as inside (ring_pieces.h). Empty if these are the
/// counts that it has, if something divides the inside, or if the outline is neither. Cost O(#E),
/// that of ring_pieces, and O(#S) for each edge that is changed.
std::vector<Index> balanced_pieces(const BoundaryMesh& boundary);

}  // namespace lpq

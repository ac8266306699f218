// The borders of a ring with the same number of edges.
#pragma once

#include <span>
#include <vector>

#include "domain/boundary.h"

namespace lpq {

/// Of the segments along either border; empty where there is no such number near what is wanted,
/// or where a segment cannot be divided.
struct RingPieces {
  std::vector<Index> outer, inner;
};

/// Of all numbers the one for which sum (n - wanted)^2 / max(wanted, 1/2) over the segments is
/// least. On its border every segment gets its share, rounded so that no node is far from where
/// equal shares would have it: rows of quads run straight from one border to the other then.
/// `outer`, `inner`: segments in the order of the border. Cost O(#segments #edges).
RingPieces ring_pieces(const SegmentPieces& pieces, std::span<const Index> outer,
                       std::span<const Index> inner);

}  // namespace lpq

// Positions along a Hilbert curve: neighbours in the order are neighbours in the plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

inline constexpr int hilbert_bits = 16;  // per axis

/// Distance along the curve of the cell (x, y), 0 <= x, y < 2^hilbert_bits.
std::uint32_t hilbert_position(std::uint32_t x, std::uint32_t y);

/// The order in which an incremental construction inserts points that are numbered along the curve:
/// a biased randomised order [Amenta, Choi, Rote 2003], drawn from a hash of the number. Rounds of
/// growing size, each along the curve, keep the expected number of flips linear whatever the
/// points.
std::vector<Index> insertion_rounds(Index count);

}  // namespace lpq

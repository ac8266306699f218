// Segments cut into pieces: the common last steps of both modes of the 1D mesh.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "domain/boundary.h"

namespace lpq {

/// Row s: the points that divide segment s, from its a to its b, unit frame, snapped.
using Division = Csr<Vec2>;

/// Number of boundary pieces of every region (or part, where the segments' sides are parts,
/// parts.h); pieces with the region on both sides do not count.
std::vector<Index> boundary_counts(std::span<const Segment> segments, Index region_count,
                                   std::span<const Index> pieces);

/// Segments, one more piece of each of which makes every region's count even. A region gets its
/// extra piece on the segment it `prefers` most among those to the outside, or, if it is enclosed,
/// towards a region nearer to the outside, which then takes its turn. At most one per region.
std::vector<Index> segments_to_even(std::span<const Segment> segments, Index region_count,
                                    std::span<const Index> pieces,
                                    std::span<const double> preference);

/// Points, edges, spacing and the order of output; without the points of the domain not `used`.
BoundaryMesh assemble(const Domain& domain, std::span<const Segment> segments,
                      std::span<const char> used, const Division& division);

}  // namespace lpq

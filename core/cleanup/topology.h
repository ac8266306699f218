// Sweeps of local operations over the connectivity of a quad mesh: what is tried where, in which
// order. What a single operation does and when it is accepted is refill.h.
#pragma once

#include "cleanup/quad_topology.h"
#include "field/field.h"

namespace lpq {

class DiskPatterns;
class IdealValence;

/// Removes interior vertices with two faces, which can never both be strictly convex:
///
///        p               p
///      / | \           /   \        the two quads (v a p b) and (v b q a)
///     a  v  b    ->   a     b       become (a q b p)
///      \ | /           \   /
///        q               q
///
/// Only where p != q and both faces are quads of one region. Returns how many were removed.
Index remove_doublets(QuadTopology& mesh);

struct TopologyStats {
  Index diamonds = 0;          // accepted refills with fewer faces,
  Index rotations = 0;         // with as many faces,
  Index splits = 0;            // with more faces;
  Index boundary_repairs = 0;  // and of all these, those that changed the quads at a fixed vertex
};

/// Refills cavities around faces that are not strictly convex until no refill makes more of them
/// valid. The number of invalid faces never grows.
TopologyStats repair_invalid(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                             DiskPatterns& patterns);

/// The same for flat quads: those with a corner of nearly 180 degrees, which most often is a wall
/// vertex with one quad instead of two. Needles stay: no connectivity widens a given angle.
TopologyStats mend_flat(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                        DiskPatterns& patterns);

/// Refills cavities around irregular vertices while that lowers the total irregularity (which
/// bounds the number of refills), without creating invalid faces or bad shapes. Cost O(#irregular).
TopologyStats regularise(QuadTopology& mesh, const IdealValence& ideal, const Fields& fields,
                         DiskPatterns& patterns);

}  // namespace lpq

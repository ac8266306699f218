// How many quads should meet at a vertex, and how much it matters when other numbers do. Inside: 4.
// A fixed vertex is cut by the edges of the 1D mesh into sectors; a sector of angle a should hold
// the k quads whose common angle a/k is nearest to 90 degrees as a ratio: k quads are better than
// k + 1 while a <= 180 k (k + 1) / (2 k + 1) degrees (switch angles 120, 216, 308.6, ...). The rule
// always leaves room for strict convexity, a / k < 180. In a hollow bend of a few edges, such as a
// hole with eight, two quads and three are nearly as good at each of its vertices, and how many
// vertices want three only the whole bend says: either is taken there. Where a mesh is part of a
// larger one, its rim counts as inside, with the quads beyond it.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "cleanup/quad_topology.h"

namespace lpq {

/// Interior angle at v of the sector that begins at the edge v -> from and ends at v -> to,
/// counter-clockwise, in (0, 2 pi]; 2 pi when both are the same edge.
double sector_angle(Vec2 v, Vec2 from, Vec2 to);

/// Cost of `valence` quads where `ideal` are wanted: an interior vertex counts 1 for one quad off
/// and more beyond; a missing quad at the boundary costs most, since it opens an angle that
/// smoothing cannot close.
double irregularity(Index valence, Index ideal, bool fixed);

/// The sectors of all fixed vertices, from the faces once; they never change afterwards.
class IdealValence {
 public:
  struct Sector {
    Index first = none;  // the sector begins at the border edge v -> first; none: full circle
    Index ideal = 4;
    bool either = false;  // two or three
  };

  explicit IdealValence(const QuadTopology& mesh);

  /// Sum over the sectors of v of irregularity(quads there, ideal); a little for two or three quads
  /// where either is taken but the other would be ideal.
  double weight(const QuadTopology& mesh, Index v) const;
  /// Sum over all vertices.
  double total_weight(const QuadTopology& mesh) const;
  bool is_regular(const QuadTopology& mesh, Index v) const { return weight(mesh, v) == 0; }
  /// The number of quads wanted at v, over all its sectors.
  Index wanted(Index v) const;
  /// Walls inside the domain cut the faces at the fixed vertex v into more than one sector.
  bool is_divided(Index v) const { return sectors_.row(v).size() > 1; }
  /// The quads that now share the sector in which face f meets v, and the number wanted there.
  struct Count {
    Index quads = 0, ideal = 4;
    bool border = false;  // counts as a fixed vertex in `irregularity`
    bool either = false;  // two or three are wanted
    double weight(Index quads) const;
  };
  Count sector_count(const QuadTopology& mesh, Index v, Index f) const;

 private:
  void find_hollow_bends(const QuadTopology& mesh, std::span<const double> angle);

  Csr<Sector> sectors_;  // one row per fixed vertex
};

}  // namespace lpq

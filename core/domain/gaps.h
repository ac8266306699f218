// The width of the domain seen from its boundary: the distance to the nearest wall across the
// inside that is not a neighbour at a common vertex (local feature size [Ruppert 1995]).
#pragma once

#include <span>
#include <vector>

#include "domain/box_tree.h"
#include "domain/domain.h"
#include "domain/spacing.h"

namespace lpq {

class Gaps {
 public:
  struct Corner {
    Index point;
    double sine, cosine;  // of the angle inside the region
  };

  Gaps(const Domain& domain, std::span<const Segment> segments);

  /// Corners of a loop, inside a region, below 60 degrees.
  std::span<const Corner> sharp_corners() const { return corners_; }

  double wall_length() const;

  /// Adds samples along both walls of every gap that asks for a spacing below the one given, but
  /// not below `floor`, densely enough that between two samples the gap changes by half at most.
  /// False: more than `most`.
  bool sample_walls(const BoundarySpacing& without_gaps, const SpacingOptions& options,
                    double floor, Index most, std::vector<BoundarySpacing::Sample>& samples) const;

 private:
  struct Piece {  // of a segment
    Vec2 a, b;
    double bound;  // of the spacing in the middle
  };

  void find_corners();
  void mark_wedge(Index corner, Index first, const std::vector<Index>& next,
                  const std::vector<char>& sharp, bool ahead);
  bool is_too_long(Index segment, const Piece& piece, double known, double growth, double floor,
                   std::vector<BoundarySpacing::Sample>& samples) const;
  double spacing_at(Index segment, Vec2 p, double reach) const;
  bool shares_wedge(Index s, Index t, Index& corner) const;

  const Domain& domain_;
  std::span<const Segment> segments_;
  BoxTree tree_;
  std::vector<Corner> corners_;
  // #S  the sharp corner at the near end of the straight run that the segment belongs to
  std::vector<Index> wedge_behind_, wedge_ahead_;
};

}  // namespace lpq

// How long the edges of the refined 1D mesh should be at every point of the boundary.
#pragma once

#include <span>
#include <vector>

#include "domain/boundary.h"
#include "domain/box_tree.h"
#include "domain/domain.h"
#include "domain/size_cones.h"

namespace lpq {

struct SpacingOptions {
  double size = 0;      // unit frame, > 0
  double growth = 0.3;  // slope of the spacing, > 0
};

/// s(x) = min(size, min over samples y of s_y + growth |x - y|): the largest function of that slope
/// below all samples. A sample stands at the ends of every short edge, along both walls of every
/// gap, in every sharp corner, and where the caller gives a size (or its size_cones there). Gaps
/// that are very long for their width are followed down to a `gap_floor` only, so that the number
/// of samples stays in proportion to the domain.
class BoundarySpacing {
 public:
  BoundarySpacing(const Domain& domain, std::span<const Segment> segments,
                  const SpacingOptions& options, std::span<const SizeSample> sizes = {});

  double operator()(Vec2 p) const { return at(p, options_.size); }
  /// The same, for a caller who knows that it is at most `bound`: faster the closer that is.
  double at(Vec2 p, double bound) const;
  /// A quick bound at a point of the domain: the shortest edge there.
  double bound(Index point) const { return bound_[point]; }

  struct Sample {
    Vec2 at;
    double spacing;
  };
  std::span<const Sample> samples() const { return samples_; }
  /// 0, or the edge length below which narrow gaps were not followed.
  double gap_floor() const { return gap_floor_; }

 private:
  BoundarySpacing(std::vector<Sample> samples, LeastCone cones, std::vector<double> bound,
                  const SpacingOptions& options);

  SpacingOptions options_;
  std::vector<Sample> samples_;
  LeastCone cones_;
  std::vector<double> bound_;  // #P
  double gap_floor_ = 0;
  BoxTree tree_;
  std::vector<double> smallest_;  // per node of the tree
};

}  // namespace lpq

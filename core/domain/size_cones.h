// What a target size at a point asks of the plane around it. In a field that grows by more than
// about a sixth of the distance, the place where it is small holds less than a quad, and no mesh
// would show it: so there the size holds on a disc first, and grows gently from its rim.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "domain/boundary.h"
#include "domain/box_tree.h"

namespace lpq {

/// h on the disc, and `slope` more per length from there on.
struct SizeCone {
  Vec2 tip;
  double h = 0;
  double reach = 0;  // radius of the disc
  double slope = 0;  // at most the growth of the field

  double at(double distance) const { return h + slope * std::max(0.0, distance - reach); }
};

/// One for each sample, in their order. A size grows by half at most within three and a half of its
/// lengths; but no faster field is lowered that other samples ask for, farther than a length away,
/// and that the growth allows: maps of many samples stay what they are. Samples of `largest` and
/// more ask for nothing. Cost O(#samples log).
std::vector<SizeCone> size_cones(std::span<const SizeSample> samples, double growth,
                                 double largest);

/// Whether some are more than h + growth * distance.
bool wider_than_growth(std::span<const SizeCone> cones, double growth);

/// The least of all cones, for many points.
class LeastCone {
 public:
  LeastCone() = default;
  explicit LeastCone(std::vector<SizeCone> cones);
  /// For a caller who knows that it is at most `bound`, or needs no more than that.
  double at(Vec2 p, double bound) const;

 private:
  std::vector<SizeCone> cones_;
  BoxTree tree_;                             // over the discs
  std::vector<double> smallest_, flattest_;  // h and slope, per node of the tree
};

}  // namespace lpq

// What every way of seeding shares: the distance to the walls, the points placed so far, and the
// packing that fills whatever is empty.
#pragma once

#include <vector>

#include "domain/boundary.h"
#include "field/field.h"
#include "geometry/grid.h"

namespace lpq {

/// Answers "is p nearer than r to a wall or a fixed node". O(1) for r of the order of h.
class WallDistance {
 public:
  WallDistance(const BoundaryMesh& boundary, const Fields& fields);
  /// r at most h(p); `h` is the size at p.
  bool nearer_than(Vec2 p, double h, double r) const;

 private:
  const BoundaryMesh& boundary_;
  PointGrid samples_;              // places along the walls
  std::vector<Index> segment_of_;  // #samples  edge, none for an isolated node
};

/// Point sets growing inward from the walls; see pack_inward.
struct Packing {
  std::vector<Vec2> points;     // boundary nodes first
  std::vector<Index> triangle;  // #points  background triangle holding each
  PointGrid grid;               // all of `points`
  Index fixed = 0;

  Packing(const BoundaryMesh& boundary, const Fields& fields);
  void add(Vec2 p, double h, Index background_triangle);
  Index interior_count() const { return static_cast<Index>(points.size()) - fixed; }
  std::vector<Vec2> interior() const { return {points.begin() + fixed, points.end()}; }
};

struct PackingRule {
  double separation =
      0.65;                // least distance to any point, maximum norm along the cross, units of h
  double clearance = 0.5;  // least distance to a wall, units of h
  Index max_points = 0;
};

/// Front from all points of `packing`, first in first out: each tries its four neighbours along the
/// cross at distance h (midpoint rule) and keeps those that are free. Cost O(#points).
void pack_inward(const BoundaryMesh& boundary, const Fields& fields, const WallDistance& walls,
                 const PackingRule& rule, Packing& packing);

}  // namespace lpq

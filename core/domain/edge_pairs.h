// Which edges of a straight-line graph may meet other than in a common end. A tree of boxes leaves
// few, but where many edges leave one vertex all boxes overlap; such edges can only lie on each
// other, and their directions tell.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/csr.h"
#include "base/function_ref.h"
#include "domain/box_tree.h"

namespace lpq {

class EdgePairs {
 public:
  using Ends = std::array<Index, 2>;

  /// Edges between two different points. Cost O(n log n).
  EdgePairs(std::span<const Vec2> points, std::vector<Ends> edges);

  /// Visits every edge that meets edge e other than in a common end or comes as near as `reach`,
  /// and others near it; some twice, perhaps e itself. Of edges that have a vertex of many edges in
  /// common only those that lie on each other are visited.
  void each_near(Index e, FunctionRef<void(Index)> visit, double reach = 0) const;

 private:
  void build_tree(std::span<const Vec2> points, std::span<const Index> degree);
  void find_bundles(std::span<const Vec2> points, std::span<const Index> degree);

  std::vector<Ends> edges_;
  std::vector<Box> boxes_;  // #edges
  BoxTree tree_;
  std::vector<Index> hub_;     // #nodes  the busy vertex that all edges below have, or none
  Csr<Index> bundles_;         // edges that leave a busy vertex in the same direction
  std::vector<Index> bundle_;  // 2 #edges  of either end: a row of bundles_, or none
};

}  // namespace lpq

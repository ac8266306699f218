// A tree of boxes over things in space, cut in halves at medians: what is near in a few steps.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/box.h"

namespace lpq {

Box3 box_of(std::span<const Vec3> points, std::span<const Index> corners);

class SpaceTree {
 public:
  struct Node {
    Box3 box;
    Index first = 0, count = 0;       // of the items, in the order of the tree
    Index left = none, right = none;  // none: a leaf
  };

  /// Things (at least one) with their boxes and the points that say in which half they belong.
  /// Cost O(n log n).
  SpaceTree(std::span<const Box3> boxes, std::span<const Vec3> centres);

  Index root() const { return static_cast<Index>(nodes_.size()) - 1; }
  const Node& node(Index i) const { return nodes_[i]; }
  std::span<const Index> items(const Node& node) const {
    return std::span(order_).subspan(node.first, node.count);
  }

  // Of waiting nodes: the tree has halves, so that one waits per level.
  static constexpr int most_waiting = 64;

 private:
  Index build(std::span<const Box3> boxes, std::span<const Vec3> centres, Index first, Index last);

  std::vector<Index> order_;  // #things
  std::vector<Node> nodes_;   // the root last
};

}  // namespace lpq

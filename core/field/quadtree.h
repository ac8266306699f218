// A balanced quadtree: leaves shrink where the size asked for is small, and side neighbours differ
// by at most one level, which bounds the growth of the leaves away from a small feature. The
// centres of its leaves are the interior points of the background mesh [Bern, Eppstein, Gilbert
// 1994]. All cell corners are origin + integer * side / 2^level, so scaling the domain by a power
// of two scales the tree without a changed bit.
#pragma once

#include <cstdint>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

class Quadtree {
 public:
  struct Box {
    Vec2 low;
    double side = 0;
    Vec2 centre() const { return {low.x + 0.5 * side, low.y + 0.5 * side}; }
  };

  Quadtree(Vec2 origin, double side);

  Index cell_count() const { return static_cast<Index>(cells_.size()); }
  bool is_leaf(Index cell) const { return cells_[cell].children == none; }
  Index child(Index cell, Index quarter) const { return cells_[cell].children + quarter; }
  Box box(Index cell) const;
  /// none outside the tree.
  Index leaf_at(Vec2 p) const;
  /// Splits a leaf that may still be split; false at the depth limit.
  bool split(Index leaf);
  /// Splits until the leaf at p is no larger than `side`. p outside the tree is ignored.
  void refine_at(Vec2 p, double side);
  /// Splits until side neighbours differ by at most one level.
  void balance();

  /// Visits the cells top-down from the root: `enter(cell, box)` says whether to go into a cell's
  /// children; it may split a leaf. Order of visits is that of the quarters.
  template <class Enter>
  void descend(Enter enter) const {
    std::vector<Index> stack{0};
    while (!stack.empty()) {
      const Index cell = stack.back();
      stack.pop_back();
      if (!enter(cell, box(cell)) || is_leaf(cell)) continue;
      for (Index quarter = 3; quarter >= 0; --quarter) stack.push_back(child(cell, quarter));
    }
  }

 private:
  struct Cell {
    std::int64_t ix = 0, iy = 0;  // position in units of side / 2^level
    Index children = none;        // first of four: low-left, low-right, high-left, high-right
    std::int32_t level = 0;
  };
  Index leaf_covering(std::int64_t ix, std::int64_t iy, std::int32_t level) const;

  Vec2 origin_;
  double side_ = 1;
  std::vector<double> side_of_level_;
  std::vector<Cell> cells_;
};

}  // namespace lpq

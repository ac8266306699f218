// A static tree of boxes over segments or points: crossing search, rays and nearest queries, each
// in about log n steps for domains as people draw them. Items are sorted along a Z-order curve and
// packed `fan` to a node, as packed R-trees are.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/box.h"

namespace lpq {

class BoxTree {
 public:
  BoxTree() = default;
  /// Items of one group, where groups are given (#boxes), have nodes of their own.
  explicit BoxTree(std::span<const Box> boxes, std::span<const Index> group = {});

  Index size() const { return static_cast<Index>(items_.size()); }
  Index node_count() const { return static_cast<Index>(boxes_.size()); }

  /// Depth first: `enter(node, box)` says whether to go on below, `visit(item)` sees the items.
  template <class Enter, class Visit>
  void walk(Enter enter, Visit visit) const;

  /// Combines a value per item into a value per node, for `enter` to prune by.
  template <class T, class Combine>
  std::vector<T> summarise(std::span<const T> per_item, Combine combine) const;

 private:
  static constexpr Index fan = 4;
  // Level 0 holds the items in order; node i of level k covers nodes fan*i .. of level k-1.
  std::vector<Index> items_;
  std::vector<Box> boxes_;          // all levels, one after another
  std::vector<Index> level_begin_;  // into boxes_, one past the last level included
};

template <class Enter, class Visit>
void BoxTree::walk(Enter enter, Visit visit) const {
  if (items_.empty()) return;
  struct Entry {
    Index level, node;
  };
  // fan - 1 waiting nodes per level, and at most 16 levels for 2^31 items.
  std::array<Entry, 64> stack;
  int height = 0;
  const Index root_level = static_cast<Index>(level_begin_.size()) - 2;
  stack[height++] = {root_level, level_begin_[root_level]};
  while (height > 0) {
    const Entry entry = stack[--height];
    if (!enter(entry.node, boxes_[entry.node])) continue;
    if (entry.level == 0) {
      visit(items_[entry.node]);
      continue;
    }
    const Index below = entry.level - 1;
    const Index first = level_begin_[below] + (entry.node - level_begin_[entry.level]) * fan;
    const Index last =
        first + fan < level_begin_[entry.level] ? first + fan : level_begin_[entry.level];
    for (Index child = last; child-- > first;) stack[height++] = {below, child};
  }
}

template <class T, class Combine>
std::vector<T> BoxTree::summarise(std::span<const T> per_item, Combine combine) const {
  std::vector<T> values(boxes_.size());
  for (Index i = 0; i < size(); ++i) values[i] = per_item[items_[i]];
  for (Index level = 1; level + 1 < static_cast<Index>(level_begin_.size()); ++level) {
    for (Index node = level_begin_[level]; node < level_begin_[level + 1]; ++node) {
      const Index first = level_begin_[level - 1] + (node - level_begin_[level]) * fan;
      values[node] = values[first];
      for (Index child = first + 1; child < first + fan && child < level_begin_[level]; ++child)
        values[node] = combine(values[node], values[child]);
    }
  }
  return values;
}

}  // namespace lpq

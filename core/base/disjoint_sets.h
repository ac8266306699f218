// Disjoint sets of 0 .. n-1 [Tarjan 1975], path halving. The root of a set is its smallest member,
// so that the answer does not depend on the order of the unions.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/index.h"

namespace lpq {

class DisjointSets {
 public:
  explicit DisjointSets(Index count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// False if they were in one set already.
  bool unite(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace lpq

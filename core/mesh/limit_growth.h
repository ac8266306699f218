// Values that may grow by so much only from one vertex to the next.
#pragma once

#include <cmath>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "base/csr.h"
#include "base/index.h"

namespace lpq {

/// Lowers h so that h[w] <= h[v] + step(v, w) along every edge; infinite values are filled. Values
/// spread in increasing order (Dijkstra), ties by index. Cost O(#V log #V).
template <class Step>
void limit_growth(const Csr<Index>& neighbours, std::span<double> h, Step step) {
  using Entry = std::pair<double, Index>;
  std::vector<Entry> finite;
  for (std::size_t v = 0; v < h.size(); ++v)
    if (std::isfinite(h[v])) finite.push_back({h[v], static_cast<Index>(v)});
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue(std::greater<>{},
                                                                       std::move(finite));
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > h[v]) continue;
    for (const Index w : neighbours.row(v)) {
      const double limit = size + step(v, w);
      if (limit < h[w]) {
        h[w] = limit;
        queue.push({limit, w});
      }
    }
  }
}

}  // namespace lpq

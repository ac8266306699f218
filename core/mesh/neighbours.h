// What lies around vertices, and values that may grow by so much only from one to the next.
#pragma once

#include <cmath>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "base/csr.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Per vertex the other ends of its edges, in half-edge order; inner edges appear twice.
Csr<Index> vertex_neighbours(std::span<const Tri> triangles, Index vertices);

/// Per vertex the triangles at it, ascending. Cost O(#T).
Csr<Index> triangles_at_vertices(std::span<const Tri> triangles, Index vertices);

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

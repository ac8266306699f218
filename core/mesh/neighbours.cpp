#include "mesh/neighbours.h"

namespace lpq {

Csr<Index> vertex_neighbours(std::span<const Tri> triangles, Index vertices) {
  Csr<Index> neighbours;
  neighbours.offsets.assign(static_cast<std::size_t>(vertices) + 1, 0);
  for (const Tri& tri : triangles)
    for (const Index v : tri) neighbours.offsets[v + 1] += 2;
  for (Index v = 0; v < vertices; ++v) neighbours.offsets[v + 1] += neighbours.offsets[v];
  neighbours.values.resize(6 * triangles.size());
  std::vector<Index> fill(neighbours.offsets.begin(), neighbours.offsets.end() - 1);
  for (const Tri& tri : triangles)
    for (int k = 0; k < 3; ++k) {
      const Index a = tri[k], b = tri[(k + 1) % 3];
      neighbours.values[fill[a]++] = b;
      neighbours.values[fill[b]++] = a;
    }
  return neighbours;
}

Csr<Index> triangles_at_vertices(std::span<const Tri> triangles, Index vertices) {
  Csr<Index> around;
  around.offsets.assign(static_cast<std::size_t>(vertices) + 1, 0);
  for (const Tri& corners : triangles)
    for (const Index v : corners) ++around.offsets[v + 1];
  for (Index v = 0; v < vertices; ++v) around.offsets[v + 1] += around.offsets[v];
  around.values.resize(3 * triangles.size());
  std::vector<Index> next(around.offsets.begin(), around.offsets.end() - 1);
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
    for (const Index v : triangles[t]) around.values[next[v]++] = t;
  return around;
}

}  // namespace lpq

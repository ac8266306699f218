#include "mesh/neighbours.h"

namespace lpq {

Csr<Index> vertex_neighbours(std::span<const Tri> triangles, Index vertices) {
  return csr_from<Index>(vertices, [&](auto&& emit) {
    for (const Tri& tri : triangles)
      for (int k = 0; k < 3; ++k) {
        emit(tri[k], tri[(k + 1) % 3]);
        emit(tri[(k + 1) % 3], tri[k]);
      }
  });
}

Csr<Index> triangles_at_vertices(std::span<const Tri> triangles, Index vertices) {
  return csr_from<Index>(vertices, [&](auto&& emit) {
    for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
      for (const Index v : triangles[t]) emit(v, t);
  });
}

}  // namespace lpq

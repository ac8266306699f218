// What lies around vertices.
#pragma once

#include <span>

#include "base/csr.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Per vertex the other ends of its edges, in half-edge order; inner edges appear twice.
Csr<Index> vertex_neighbours(std::span<const Tri> triangles, Index vertices);

/// Per vertex the triangles at it, ascending. Cost O(#T).
Csr<Index> triangles_at_vertices(std::span<const Tri> triangles, Index vertices);

}  // namespace lpq

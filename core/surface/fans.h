// Corners round one vertex that hang together: what a vertex is once a surface is cut open.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct SurfaceFans {
  Csr<Index> corners;            // per fan: half-edges that leave it, counter-clockwise
  std::vector<char> closed;      // #fans  all round the vertex
  std::vector<Index> of_corner;  // #half-edges

  Index count() const { return corners.rows(); }
};

/// Fans that cross no barrier: a half-edge without a twin, or one marked in `barrier` (both sides
/// marked; empty for none). Numbered by their first corner. An open fan begins at its barrier.
SurfaceFans fans_of(std::span<const Index> twins, std::span<const char> barrier = {});

/// Radians between half-edge e and the one before it in its triangle.
double corner_angle(const SurfaceMesh& mesh, Index e);

}  // namespace lpq

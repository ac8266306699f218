// Which side of which face each edge of the 1D mesh is: how finite element programs name
// boundaries.
#pragma once

#include <vector>

#include "mesh/output_mesh.h"

namespace lpq {

struct EdgeSide {
  Index face = none;  // none: no face has this edge
  int side = 0;       // from corner `side` to the next one
};

/// One per edge: of the face on its left, or on its right where there is none on the left.
/// Cost O((#F + #E) log #E).
std::vector<EdgeSide> edge_sides(const OutputMesh& mesh);

}  // namespace lpq

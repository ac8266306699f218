// Which edges of a mesh file are the boundary its domain asks for.
#pragma once

#include <array>
#include <vector>

#include "base/result.h"
#include "domain/domain.h"
#include "mesh/output_mesh.h"

namespace lpq {

struct BoundaryMatch {
  std::vector<std::array<Index, 2>> outline;  // directed mesh edges, domain on the left
  std::vector<std::array<Index, 2>> walls;    // mesh edges inside, a < b, sorted
  Index kept = 0;                             // domain edges that are one mesh edge
  Index divided = 0;                          // domain edges that are a chain of mesh edges
};

/// Every domain point must be a mesh vertex bit for bit, every domain edge a mesh edge or a chain
/// of them; a chain's inner nodes may lie off the straight line by the rounding of their
/// coordinates. Errors: no_valid_mesh, with the place, where that is not so. Cost O(n log n).
Result<BoundaryMatch> match_boundary(const Domain& domain, const OutputMesh& mesh);

/// The mesh's own outline: directed edges with a face on their left only.
std::vector<std::array<Index, 2>> own_outline(const OutputMesh& mesh);

}  // namespace lpq

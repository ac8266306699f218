// Makes tangled faces strictly convex by moving free vertices, and only those near them. Per
// cluster of invalid faces with a few rings of neighbours: first every vertex in turn to the
// Chebyshev centre of its star (star_centre.h), then all of them together by the regularised mean
// ratio with epsilon going to zero [Escobar et al. 2003], then the centres again. A cluster keeps
// its new positions only if fewer of its faces are invalid by exact signs.
#pragma once

#include "mesh/quad_mesh.h"

namespace lpq {

/// Faces that are not strictly convex, by exact signs.
std::vector<Index> invalid_faces(const QuadMesh& mesh);

/// Returns the number of faces made valid. No valid face becomes invalid unless more become valid.
Index untangle(QuadMesh& mesh);

enum class Untangling {
  quick,     // star centres of the tangled vertices: enough for a patch that fits its place
  patient,   // and of their neighbours
  thorough,  // all of the above
};

/// The same for a whole small mesh, without looking for clusters.
void untangle_patch(QuadMesh& patch, Untangling untangling);

}  // namespace lpq

// Before the matching: a fan at a wall with fewer triangles than the quads it should hold can only
// get too few quads, and a single quad over a straight angle is never valid. Flipping the edge
// opposite the vertex gives it another triangle.
#pragma once

#include "mesh/tri_mesh.h"

namespace lpq {

/// Flips edges (never walls) where that lowers the number of missing triangles at wall vertices;
/// the new triangles are strictly counter-clockwise. Returns the number of flips. Cost O(#T).
Index prepare_corners(TriMesh& mesh);

}  // namespace lpq

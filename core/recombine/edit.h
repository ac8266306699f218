// Local edits of a triangulation that keep its twins right.
#pragma once

#include "base/check.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Whether the two triangles at e form a strictly convex quadrilateral (exact signs).
bool is_flippable(const TriMesh& mesh, Index e);

/// Replaces the edge between two triangles by the other diagonal of their quadrilateral. Afterwards
/// triangle_of(e) and triangle_of(twin) are still the two triangles.
void flip_edge(TriMesh& mesh, Index e);

/// Puts a new vertex at the centroid of triangle t and joins it to the three corners. The part at
/// edge k of the old triangle is t, #T, #T + 1 for k = 0, 1, 2.
void split_triangle(TriMesh& mesh, Index t);

}  // namespace lpq

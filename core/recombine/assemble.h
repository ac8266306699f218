// From the chosen pairs to a quad mesh.
#pragma once

#include <vector>

#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"
#include "recombine/fans.h"

namespace lpq {

/// What becomes of each triangle: merged across a half-edge, an end of a split fan, or neither.
struct Pairing {
  std::vector<Index> merge;  // #T  its half-edge to the partner, none if not merged
  std::vector<Index> split;  // #T  fan of the chosen extra edge, none if not an end triangle
};

/// Faces in the order of their lowest triangle, each from its lowest vertex on. A chosen extra edge
/// at v adds a vertex v' that takes v's place in the triangles strictly between the fan's ends,
/// which become the quads (v, a, x, v') and (v, v', y, b):
///
///      x-------y            x-------y
///     / .     . .          / .     . .
///    /    . .    .   ->   /   . v'.   .
///   a-------v-----b      a------v------b
///
QuadMesh assemble(const TriMesh& mesh, const Fans& fans, const Pairing& pairing);

/// Constraint edges with the mesh on both sides, a < b, sorted.
std::vector<std::array<Index, 2>> inner_walls(const TriMesh& mesh);

}  // namespace lpq

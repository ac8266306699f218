// A few faces of a mesh on a surface as a mesh of their own, to be worked on and put back.
#pragma once

#include <vector>

#include "base/csr.h"
#include "shell/shape/freedom.h"

namespace lpq {

struct ShapePatch {
  ShellMesh mesh;
  std::vector<VertexRole> roles;  // rim vertices are fixed
  std::vector<Index> vertex;      // #V of the patch  number in the whole mesh; none: new
  std::vector<Index> faces;       // of the whole mesh
  std::vector<char> rim;          // #V of the patch  has faces outside
  bool changed = false;           // other faces than those it was taken with
};

/// Faces at every vertex, ascending; dead ones (no corners) have none.
Csr<Index> faces_at_vertices(const ShellMesh& mesh);

/// f and the faces in so many rings around it, ascending. `stars`: of the mesh.
std::vector<Index> faces_around(const ShellMesh& mesh, const Csr<Index>& stars, Index f, int rings);

/// `faces`: ascending; `stars`: of the whole mesh.
ShapePatch take_patch(const ShellMesh& mesh, const std::vector<VertexRole>& roles,
                      const Csr<Index>& stars, std::vector<Index> faces);

/// Puts positions and faces back. If the faces changed, those that it was taken with are dead then
/// (no corners), and new vertices and faces come last.
void put_back(const ShapePatch& patch, ShellMesh& mesh, std::vector<VertexRole>& roles);

/// Sweeps out dead faces and vertices without faces; the order of the others is kept.
void sweep_unused(ShellMesh& mesh, std::vector<VertexRole>& roles);

}  // namespace lpq

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

/// The same while patches are put back with other faces.
class FaceStars {
 public:
  explicit FaceStars(const ShellMesh& mesh);
  std::span<const Index> row(Index v) const { return rows_.row(row_[v]); }
  /// After `patch` was put back with other faces. Cost: of the patch, not of the mesh.
  void update(const ShellMesh& mesh, const ShapePatch& patch);

 private:
  Csr<Index> rows_;         // one without faces behind those of the first stars, new ones after it
  Index no_faces_;          // this one
  std::vector<Index> row_;  // #V
  std::size_t face_count_;  // of the mesh, dead ones too
};

/// f and the faces in so many rings around it, ascending. `stars`: of the mesh.
std::vector<Index> faces_around(const ShellMesh& mesh, const FaceStars& stars, Index f, int rings);

/// `faces`: ascending; `stars`: of the whole mesh.
ShapePatch take_patch(const ShellMesh& mesh, const std::vector<VertexRole>& roles,
                      const FaceStars& stars, std::vector<Index> faces);

/// Puts positions and faces back. If the faces changed, those that it was taken with are dead then
/// (no corners), and new vertices and faces come last.
void put_back(const ShapePatch& patch, ShellMesh& mesh, std::vector<VertexRole>& roles);

/// Sweeps out dead faces and vertices without faces; the order of the others is kept.
void sweep_unused(ShellMesh& mesh, std::vector<VertexRole>& roles);

}  // namespace lpq

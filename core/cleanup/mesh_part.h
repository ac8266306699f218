// Small parts of a mesh as meshes of their own, so that a local trouble is solved locally: its line
// searches and its failures are its own.
#pragma once

#include "base/csr.h"
#include "mesh/quad_mesh.h"

namespace lpq {

struct MeshPart {
  QuadMesh mesh;              // vertices that are fixed or have faces outside come first, as fixed
  std::vector<Index> vertex;  // number in the whole mesh
};

/// The given faces (ascending) as a mesh; `stars` are the faces at every vertex of the whole.
MeshPart extract_part(const QuadMesh& whole, const Csr<Index>& stars,
                      const std::vector<Index>& faces);

/// Copies the positions of the part's free vertices back.
void put_back(const MeshPart& part, QuadMesh& whole);

/// The seed faces with `rings` rings of faces around them, as connected clusters, each ascending.
std::vector<std::vector<Index>> face_clusters(const QuadMesh& mesh, const Csr<Index>& stars,
                                              const std::vector<Index>& seeds, int rings);

}  // namespace lpq

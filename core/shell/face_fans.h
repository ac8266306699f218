// Faces in space as triangles round their middles, which follow the mesh's own points.
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"
#include "shell/shell_mesh.h"

namespace lpq {

struct FaceFans {
  std::vector<Vec3> points;    // the mesh's, then the middle of every face
  std::vector<Tri> triangles;  // a side of the face, its middle last
  std::vector<Index> face;     // #triangles
};

/// Cost O(#V + #F).
FaceFans face_fans(const ShellMesh& mesh);

}  // namespace lpq

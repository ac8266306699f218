// Stanford PLY (.ply, ASCII): true quads for MeshLab, Blender and Python. Format: Greg Turk, "The
// PLY polygon file format", 1994.
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// Double coordinates; the quads, then the triangles, with `region` as a property of the faces and
/// the regions' names as comments. No edges: most readers take an element they do not know for an
/// error.
std::string write_ply(const OutputMesh& mesh);

}  // namespace lpq

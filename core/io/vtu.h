// VTK XML unstructured grid (.vtu, ASCII) for ParaView, PyVista and VTK.
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// Quads and triangles with cell data `region` and `eta`, and the 1D mesh as line cells with cell
/// data `tag`; names of regions and tags as field data.
std::string write_vtu(const OutputMesh& mesh);

}  // namespace lpq

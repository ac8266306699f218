// VTK XML unstructured grid (.vtu, ASCII) for ParaView, PyVista and VTK.
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// Quads and triangles with cell data `region` and `eta`, the 1D mesh as line cells and the tagged
/// points as vertex cells with cell data `tag` (-1 = none); names of regions and tags as field
/// data `region_names` and `tag_names`: the bytes of UTF-8 with a zero after each name.
std::string write_vtu(const OutputMesh& mesh);

}  // namespace lpq

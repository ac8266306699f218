// Legacy VTK (.vtk, ASCII, version 3.0) for everything that reads no VTU: old ParaView scripts,
// Gmsh, MATLAB readers. Format: "VTK file formats", VTK user's guide, section "Simple legacy
// formats".
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// The cells, the cell data and the field data of write_vtu.
std::string write_vtk(const OutputMesh& mesh);

}  // namespace lpq

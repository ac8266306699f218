// `lpquad check` where the mesh lies in space.
#pragma once

#include <string>

#include "base/result.h"
#include "mesh/output_mesh.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct ShellVerdict {
  std::string text;        // quality and counts, row by row
  std::string violations;  // a line each; "" = valid
};

/// Topology, convex corners and quality of a mesh in space; with a surface also whether it hangs
/// together as that does, and how far they lie apart.
ShellVerdict judge_shell(const OutputMesh& mesh, const SurfaceMesh* surface);

/// Reads and repairs the surface of a file; `weld` as in RepairOptions. Errors: those of the
/// readers and of repair_surface.
Result<SurfaceMesh> load_surface(const std::string& name, double weld);

}  // namespace lpq

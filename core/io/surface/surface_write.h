// Triangulated surfaces as files.
#pragma once

#include <span>
#include <string>

#include "mesh/surface_mesh.h"

namespace lpq {

/// Wavefront OBJ with 17 digits; triangles in their order, a new group wherever it changes.
std::string write_surface_obj(const SurfaceMesh& surface, std::span<const std::string> group_names);

}  // namespace lpq

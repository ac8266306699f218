// Triangulated surfaces as files.
#pragma once

#include <span>
#include <string>

#include "mesh/surface_mesh.h"

namespace lpq {

/// Wavefront OBJ with 17 digits; triangles in their order, a new group (g) wherever it changes, and
/// a new object (o) wherever the body does. Each group and body has a name of its own.
std::string write_surface_obj(const SurfaceMesh& surface, std::span<const std::string> group_names,
                              std::span<const std::string> body_names = {});

}  // namespace lpq

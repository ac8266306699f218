// The charts of a surface run as a file: every triangle of the surface with its place in the plane.
#pragma once

#include <string>

#include "shell/mesh_surface.h"

namespace lpq {

/// Wavefront OBJ: the surface as repaired, `v` in space, `vt` in the unit square, one island per
/// chart, a group "FACE chart_N" each. Islands are maps of their charts up to one scale that all
/// have in common; a comment says it. Every triangle is there once, and turns left in the square
/// (but for triangles too flat for the digits).
std::string write_atlas_obj(const ShellOutcome& outcome);

}  // namespace lpq

// Wavefront OBJ as a surface.
#pragma once

#include <string_view>

#include "base/result.h"
#include "surface/soup.h"

namespace lpq {

/// Reads v (the first three numbers), f (any number of corners, negative indices, v/vt/vn; vertices
/// may come after), and o, g and usemtl, which together name the group of a face (o not twice,
/// where g begins with it); objects (o) are bodies, unless they are loose: see surface/bodies.h;
/// other lines are passed over, lines may go on after a backslash. Faces with fewer than three
/// corners are left out with a warning. Errors: parse_error or non_finite with line and byte; empty
/// without a face.
Result<SurfaceSoup> read_obj_surface(std::string_view text);

}  // namespace lpq

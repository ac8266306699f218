// The triangles and quads of a Gmsh mesh as a surface.
#pragma once

#include <string_view>

#include "base/result.h"
#include "surface/soup.h"

namespace lpq {

/// Versions 2.0 - 2.2, 4.0 and 4.1, ASCII or binary. Triangles and quads of first or second order
/// (as their corners, with a warning); points and lines are passed over, with a warning of physical
/// curves, volumes too, with a warning. The group of an element is its physical surface, of several
/// the first, with a warning, or without one its elementary surface.
/// Errors: parse_error with byte, and of ASCII with line; empty without a triangle or quad.
Result<SurfaceSoup> read_msh_surface(std::string_view text);

}  // namespace lpq

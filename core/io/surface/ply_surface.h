// PLY as a surface.
#pragma once

#include <string_view>

#include "base/result.h"
#include "surface/soup.h"

namespace lpq {

/// Text, or bytes of either order. Of element `vertex` x, y, z and, as the size wanted there, size;
/// of element `face`, which may come first, the corners (vertex_indices or vertex_index) and, as
/// its group, an integer property region, group or material_index; of element `tristrips` strips of
/// triangles, -1 between them; everything else is passed over. Faces with fewer than three corners
/// are left out with a warning. Memory is bounded by the size of the file. Errors: parse_error or
/// non_finite with the byte, for texts also the line; empty without a face.
Result<SurfaceSoup> read_ply_surface(std::string_view bytes);

}  // namespace lpq

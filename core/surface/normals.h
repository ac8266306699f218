// Unit normals of triangles, also of those that hardly have one.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace lpq {

/// A triangle so flat that its own normal is rounding noise takes that from across its longest
/// edge: edges beside it are then as sharp as the sheets that it lies between. Where mesh sizes are
/// given (#V), needles that are nothing beside them count as flat, too, unless many together are as
/// wide as a face. Normals do not come over the borders of groups; where the longest edge has none
/// behind it, the next does. Zero where nothing helps. #T
std::vector<Vec3> triangle_normals(const SurfaceMesh& mesh, std::span<const double> size = {});

}  // namespace lpq

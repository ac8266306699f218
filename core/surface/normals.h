// Unit normals of triangles, also of those that hardly have one.
#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace lpq {

/// Length of the diagonal of the bounding box.
double bounding_diagonal(const std::vector<Vec3>& points);

/// A triangle so flat that its own normal is rounding noise takes that from across its longest
/// edge, where there is one: edges beside it are then as sharp as the sheets that it lies between.
/// Zero where nothing helps. #T
std::vector<Vec3> triangle_normals(const SurfaceMesh& mesh);

}  // namespace lpq

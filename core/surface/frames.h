// A frame for each triangle: the x axis along its first edge, y to the left. Laid out from lengths
// alone, so that it exists for needles and caps as well.
#pragma once

#include "geometry/vec.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct TriangleLayout {
  Vec2 side[3];     // half-edge k as a vector in the triangle's frame; they sum to zero
  double area = 0;  // >= 0
};
TriangleLayout layout_of(const SurfaceMesh& mesh, Index t);

/// The axes in space; orthonormal whatever the triangle.
struct TriangleAxes {
  Vec3 x, y, normal;
};
TriangleAxes axes_of(const SurfaceMesh& mesh, Index t);

}  // namespace lpq

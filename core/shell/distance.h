// How far a mesh and the surface that was meshed lie from each other, both ways.
#pragma once

#include <span>

#include "mesh/surface_mesh.h"
#include "shell/shell_mesh.h"

namespace lpq {

struct Distance {
  double max = 0, mean = 0;  // mean over the area
  Vec3 at;                   // where it is largest
};

struct SurfaceDistance {
  Distance to_surface;  // from the mesh: vertices, middles of edges and of faces
  // From the surface: vertices, and places a quarter of a side apart, or more where the mesh is far
  // finer than elsewhere.
  Distance from_surface;
};

/// Measured at samples: the distance between them may be a little more. A quad counts as the four
/// triangles round its middle. Both need a face. Cost O(#samples log #F).
SurfaceDistance surface_distance(std::span<const Vec3> points, std::span<const Tri> triangles,
                                 const ShellMesh& mesh);

}  // namespace lpq

// How far a mesh lies from the surface it is of, both ways.
#pragma once

#include <span>

#include "mesh/surface_mesh.h"
#include "shell/shell_mesh.h"

namespace lpq {

struct Distance {
  double max = 0, mean = 0;  // mean over the area
};

struct SurfaceDistance {
  Distance to_surface;    // from the mesh: vertices, middles of edges and of faces
  Distance from_surface;  // from the vertices of the surface
};

/// A quad counts as the four triangles round its middle. Both need a face.
/// Cost O((#V + #F) log #F) for either.
SurfaceDistance surface_distance(std::span<const Vec3> points, std::span<const Tri> triangles,
                                 const ShellMesh& mesh);

}  // namespace lpq

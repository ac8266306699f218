// Neighbours and one orientation for a heap of triangles.
#pragma once

#include "mesh/surface_mesh.h"

namespace lpq {

struct Orientation {
  Index turned = 0;            // triangles whose corners were swapped
  Index components = 0;        // parts connected across edges of two triangles
  Index borders = 0;           // edges of one triangle
  Index nonmanifold = 0;       // edges of three or more triangles
  Index conflicts = 0;         // edges that cut a one-sided part open
  Index pinched_vertices = 0;  // where parts meet in this one point only
};

/// Fills mesh.twins and turns triangles so that the two of every edge of two agree, breadth first
/// from the first triangle of each part. A part of which some were turned ends up with its outside
/// out if it is closed, else as most of its triangles were. Every other edge is a wall: borders,
/// edges where more than two triangles meet, and edges where a one-sided part (a Moebius band)
/// comes back the wrong way round. Where a sheet goes on beneath another that ends on it, its two
/// triangles are twins all the same. No triangle may repeat a corner. Cost O(#T log valence).
Orientation orient_surface(SurfaceMesh& mesh);

}  // namespace lpq

// The clipped Voronoi diagram (paper section 3.1) of a constrained Delaunay triangulation, with
// symbolic vertices: each remembers which bisectors and which wall made it. For pictures, tests and
// inspection; the energy uses the dual form (voronoi/dual.h) that this is written out from.
#pragma once

#include <array>
#include <vector>

#include "base/csr.h"
#include "geometry/vec.h"
#include "mesh/tri_mesh.h"
#include "voronoi/dual.h"

namespace lpq {

struct VoronoiVertex {
  Vec2 point;
  VertexKind kind = VertexKind::three_bisectors;
  std::array<Index, 3> sites{none, none,
                             none};  // generators; the cell's own site first not required
  Index wall = none;                 // wall half-edge, for a vertex on a wall
};

struct ClippedVoronoi {
  std::vector<VoronoiVertex> vertices;
  Csr<FanTriangle> cells;  // one row per mesh vertex; c1, c2 index `vertices`
};

/// Cells of every vertex of a constrained Delaunay triangulation, clipped by its walls. Interior
/// cells that reach a wall are found by propagation from the wall (section 3.1.2) and clipped by
/// Sutherland-Hodgman (section 3.1.3); boundary cells are closed at the midpoints of their walls.
/// Post: the areas sum to the domain's area to rounding. Cost O(#V).
void clip_voronoi(const TriMesh& mesh, ClippedVoronoi& result);

/// Closed polygons per site, for pictures and outside checks (a boundary site with several fans,
/// or a concave one, may have more than one piece).
std::vector<std::vector<std::vector<Vec2>>> cell_polygons(const TriMesh& mesh,
                                                          const ClippedVoronoi&);

}  // namespace lpq

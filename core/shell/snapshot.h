// What can be seen of a run on a surface at any moment, layer by layer, as pipeline/snapshot.h has
// it for the plane. A layer is empty until its stage is over; cells and quads can be seen while
// charts are meshed.
#pragma once

#include <vector>

#include "pipeline/snapshot.h"
#include "shell/mesh_surface.h"

namespace lpq {

/// The edges that the mesh must follow, corners, and the faces between.
struct FeatureLayer {
  std::vector<std::array<Index, 2>> edges;  // #E  vertices of the surface
  std::vector<Index> kinds;                 // #E  FeatureKind: 1 .. 4
  std::vector<Index> corners;               // vertices
  std::vector<Index> faces;                 // #T  face of each triangle
};

/// The cross field, on the triangles.
struct SurfaceCrossLayer {
  std::vector<Vec3> axes;                         // #T  one arm, of unit length
  std::vector<SurfaceSingularity> singularities;  // by vertex
};

/// The maps to the plane.
struct ChartLayer {
  std::vector<Index> charts;               // #T  chart of each triangle
  std::vector<Vec2> uv;                    // 3 #T  of each corner, in the chart's own plane
  std::vector<std::array<Index, 2>> cuts;  // borders of charts that are no features
};

/// What L_p moves: the cells in the chart that is being meshed.
struct ChartCellLayer {
  Index chart = none;        // none: there is no such chart now
  CellLayer plane;           // in the chart's own plane
  std::vector<Vec3> points;  // of its polygons, on the surface
};

/// The quads of the charts meshed so far, or of the whole surface.
struct ShellLayer {
  std::vector<Vec3> points;                 // #V
  std::vector<Face> faces;                  // #F  quads first, then triangles
  std::vector<Index> regions;               // #F  face of the surface
  std::vector<double> eta;                  // #F  0 for a triangle
  std::vector<Index> valence;               // #V  faces at the vertex
  std::vector<Index> pins;                  // #V  Pin: free 0, on a feature or border 1, corner 2
  std::vector<std::array<Index, 2>> edges;  // #E  on features and borders
};

FeatureLayer feature_layer(const SurfaceMesher& mesher);
SurfaceCrossLayer cross_layer(const SurfaceMesher& mesher);
ChartLayer chart_layer(const SurfaceMesher& mesher);
ChartCellLayer chart_cell_layer(const SurfaceMesher& mesher);
ShellLayer shell_layer(const SurfaceMesher& mesher);

}  // namespace lpq

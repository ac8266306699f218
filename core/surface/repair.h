// From a heap of triangles to a surface that nothing is wrong with any more; every repair is
// counted.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "mesh/surface_mesh.h"
#include "surface/slits.h"
#include "surface/soup.h"

namespace lpq {

struct RepairOptions {
  /// Points nearer than this, relative to the bounding box's diagonal, are one point. 1e-10 is what
  /// rounding leaves of equal points; files whose sheets do not quite meet may need 1e-7 or more.
  /// A file whose triangles hardly hang together at all gets the least of 1e-8 .. 1e-5 that makes
  /// them: it has rounded its points face by face. Slits of 1e-6 are closed as well, and points
  /// that hang on edges as near as the larger of the two become theirs.
  double weld = 1e-10;  // 0 .. 0.01; below 1e-15, as 0, nothing but equal points is joined
};

struct RepairReport {
  Index points_given = 0, triangles_given = 0;
  Index welded_points = 0;        // became one with an earlier point
  double rounding = 0;            // the distance of welding where it had to be larger: see weld
  Index slit_points = 0;          // the same, across gaps of no width (slits.h)
  Index hanging_points = 0;       // lay on an edge of another sheet, and divide it (hanging.h)
  Index unused_points = 0;        // no triangle has them
  Index collapsed_triangles = 0;  // two corners are one point
  Index duplicate_triangles = 0;  // same three corners as an earlier one, either way round
  Index flat_triangles = 0;       // without height, taken away (flat.h)
  Index divided_triangles = 0;    // next to those
  Index flat_left = 0;            // without height, still there
  Index turned_triangles = 0;     // for one orientation
  Index components = 0;           // connected across edges of two triangles
  Index border_edges = 0;
  Index nonmanifold_edges = 0;     // of three or more triangles: always features
  Index conflict_edges = 0;        // where one-sided parts are cut open: walls
  BorderGap gap;                   // up to 1e-3 of the diagonal: left open
  double closing_weld = 0;         // what would close it
  Index nonmanifold_vertices = 0;  // parts meet in the point only; each is an umbrella of its own
};

struct RepairedSurface {
  SurfaceMesh mesh;                      // points in the order of the soup
  std::vector<double> sizes;             // #V or empty: the least of the points that became one
  std::vector<Index> vertex_of_point;    // #points of the soup; none where no triangle has it
  std::vector<std::string> group_names;  // of mesh.group
  std::vector<std::string> body_names;   // of mesh.body
  RepairReport report;
};

/// Welds within bodies, drops and divides triangles, orients, and cuts where the surface is not
/// manifold (but not a sheet beneath another that ends on it, see orient.h). A point that triangles
/// of several bodies have becomes several; those come last. Errors: those of check_soup();
/// bad_option; lost_precision where welding would make one point of nearly all; zero_area if
/// nothing has height. Cost O(#T log #T).
Result<RepairedSurface> repair_surface(SurfaceSoup soup, const RepairOptions& options = {});

}  // namespace lpq

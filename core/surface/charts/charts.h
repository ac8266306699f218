// The faces of a surface as parts with maps to the plane, one conformal map each, cut as often as
// it takes: every part's map is injective, and its scale varies by a bounded factor.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/surface_mesh.h"
#include "mesh/tri_mesh.h"
#include "surface/charts/map_part.h"

namespace lpq {

struct Chart {
  Index face = none;             // component of triangles across edges that are no features
  std::vector<Index> triangles;  // #T  of the surface, ascending
  std::vector<Index> vertex;     // #V  of the surface, several times where the part is cut open
  TriMesh plane;                 // the same triangles in the plane, own vertices, walls at borders
  std::vector<double> scale;     // #T  sqrt(area in the plane / area in space)
  Csr<Index> borders;            // half-edges of the surface, loop by loop, the outer loop first
  MapMethod method = MapMethod::none_found;
  MapCheck check;

  /// Half-edge of the surface that half-edge e of `plane` is.
  Index on_surface(Index e) const { return 3 * triangles[triangle_of(e)] + e % 3; }
};

struct ChartOptions {
  MapLimits limits;
};

/// What happened on the way, for tests and benchmarks.
struct ChartCounts {
  Index maps = 0;                                                 // solved for
  Index topology = 0, flips = 0, crossings = 0, distortions = 0;  // splits, by reason
  Index opened = 0;                                               // tubes that one cut made a disk
  Index merged = 0;    // pairs of parts that one map serves after all
  Index rejected = 0;  // charts without a map (none_found): single triangles without area
};

struct Atlas {
  std::vector<Chart> charts;  // by their first triangle
  std::vector<char> cut;      // #half-edges  on the border of a chart: walls, features, cuts
  ChartCounts counts;
};

/// `feature` marks half-edges (both sides); half-edges without twin are borders anyway. Features
/// with the same face on both sides are cut only where that helps. Every triangle is in one chart.
/// Cost: a few sparse factorisations per part.
Atlas make_charts(const SurfaceMesh& mesh, std::span<const char> feature,
                  const ChartOptions& options = {});

}  // namespace lpq

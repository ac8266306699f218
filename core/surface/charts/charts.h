// The faces of a surface as parts with maps to the plane, one conformal map each, cut as often as
// it takes: every part's map is injective, and its scale varies by a bounded factor.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/surface_mesh.h"
#include "mesh/tri_mesh.h"
#include "surface/charts/checks.h"

namespace lpq {

enum class MapMethod { bff, lscm, scp, symmetric_dirichlet, none_found };
const char* method_name(MapMethod method);

struct Chart {
  Index face = none;             // component of triangles across edges that are no features
  std::vector<Index> triangles;  // #T  of the surface; own half-edge 3 i + k is 3 triangles[i] + k
  std::vector<Index> vertex;     // #V  of the surface, several times where the part is cut open
  TriMesh plane;                 // the same triangles in the plane, own vertices, walls at borders
  std::vector<double> scale;     // #T  sqrt(area in the plane / area in space)
  Csr<Index> borders;            // half-edges of the surface, loop by loop, the outer loop first
  MapMethod method = MapMethod::none_found;
  MapCheck check;
};

struct ChartOptions {
  MapLimits limits;
};

/// What happened on the way, for reports and benchmarks.
struct ChartCounts {
  Index maps = 0;                                                 // solved for
  Index loop_cuts = 0;                                            // kept
  Index topology = 0, flips = 0, crossings = 0, distortions = 0;  // splits, by reason
  Index merges = 0, rejected = 0;  // rejected: charts without a valid map (none_found)
};

struct Atlas {
  std::vector<Chart> charts;
  std::vector<char> cut;  // #half-edges  border of a chart: features between faces, walls and cuts
  ChartCounts counts;
};

/// `feature` marks half-edges (both sides); half-edges without twin are borders anyway. Features
/// with the same face on both sides are not cut unless they have to be. A chart of one triangle
/// that has no area is rejected, nothing else is. Cost: a few sparse factorisations of each part.
Atlas make_charts(const SurfaceMesh& mesh, std::span<const char> feature,
                  const ChartOptions& options = {});

}  // namespace lpq

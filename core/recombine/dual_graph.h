// The graph whose perfect matchings are the ways to merge triangles in pairs: a node per triangle,
// an edge per pair of neighbours not separated by a wall, and the extra edges of Blossom-Quad
// [Remacle et al. 2012] between the two end triangles of a wall vertex's fan.
#pragma once

#include <vector>

#include "field/field.h"
#include "matching/blossom.h"
#include "mesh/tri_mesh.h"
#include "recombine/fans.h"

namespace lpq {

/// Which triangles may stay unmerged.
enum class Leave {
  one_per_odd_part,  // an odd part of the mesh gets one partner node for all its triangles
  where_cheaper,     // any triangle, at leave_cost
};

struct DualGraph {
  Index nodes = 0;              // triangles first
  std::vector<CostEdge> edges;  // merges, then extra edges, then edges of other nodes
  std::vector<Index> source;    // half-edge of a merge, fan of an extra edge
  Index merges = 0;             // number of these
};

/// Leaving triangles is written by doubling: two copies of the graph, and an edge of twice the
/// price between the copies of each triangle; each copy of an optimal matching is then optimal.
DualGraph make_dual_graph(const TriMesh& mesh, const Fans& fans, const Fields& fields,
                          double alignment_weight, Leave leave);

}  // namespace lpq

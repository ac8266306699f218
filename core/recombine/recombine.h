// Triangles to quads by a minimum-cost perfect matching of the dual graph (Blossom-Quad, paper
// section 5, [Remacle et al. 2012]).
#pragma once

#include <vector>

#include "base/result.h"
#include "field/field.h"
#include "matching/blossom.h"
#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct RecombineOptions {
  bool all_quads = true;          // false: a triangle may stay where pairing costs more than it
  double alignment_weight = 0.6;  // weight of the cross-field term beside 1 - eta, >= 0
  bool keep_matching = false;     // return the graph and duals for --stages
};

enum class RecombineStatus {
  all_quads,
  triangles_left,  // quad-dominant as asked, or one triangle per part (between walls) of odd size
};

struct RecombineResult {
  RecombineStatus status = RecombineStatus::all_quads;
  QuadMesh mesh;
  Index extra_edges = 0;  // chosen extra edges, each repaired by one new vertex
  Index triangles = 0;    // left over
  std::int64_t cost = 0;  // of the matching
  Index splits = 0;       // triangles split in three to make a perfect matching possible
  // keep_matching: what was matched. Nodes 0 .. #T-1 of the graph are the triangles; further nodes
  // are partners of left-over triangles, or a second copy of the graph (see dual_graph.h).
  TriMesh triangulation;        // after flips and splits
  std::vector<CostEdge> graph;  // dual graph
  Matching matching;
  std::vector<Index> pair_of;  // #T  the triangle merged with, none if left over
};

/// Costs are round(10^4 (1 - eta + w misalignment)), plus a penalty for eta = 0 and for a number of
/// quads at a wall vertex that does not fit its angle (costs.h). Extra edges join the two end
/// triangles of a wall vertex's fan; a chosen one is repaired by splitting that vertex, which
/// leaves no triangle. Where no perfect matching exists, triangles are split in three until one
/// does (always possible, see repair.h). The result's topology is that of a valid mesh; quads may
/// be non-convex. Deterministic; cost O(#T) beside the matching.
RecombineResult recombine(const TriMesh& mesh, const Fields& fields,
                          const RecombineOptions& options = {});

}  // namespace lpq

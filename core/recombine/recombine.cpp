// Order of work: give wall vertices the triangles they need, match, mend the triangulation where no
// perfect matching exists and match again, then build the quads.
#include "recombine/recombine.h"

#include "recombine/assemble.h"
#include "recombine/dual_graph.h"
#include "recombine/fans.h"
#include "recombine/prepare_corners.h"
#include "recombine/repair.h"

namespace lpq {
namespace {

struct Solved {
  Fans fans;
  DualGraph graph;
  Matching matching;
};

Solved solve(const TriMesh& mesh, const Fields& fields, const RecombineOptions& options,
             Leave leave) {
  Solved solved;
  solved.fans = find_fans(mesh);
  solved.graph = make_dual_graph(mesh, solved.fans, fields, options.alignment_weight, leave);
  solved.matching = min_cost_perfect_matching(solved.graph.nodes, solved.graph.edges,
                                              {.duals = options.keep_matching});
  LPQ_ASSERT(solved.matching.status != MatchingStatus::invalid_input);
  return solved;
}

/// A perfect matching of the triangulation, whose triangles are split where there was none.
Solved solve_all_quads(TriMesh& mesh, const Fields& fields, const RecombineOptions& options) {
  Solved solved = solve(mesh, fields, options, Leave::one_per_odd_part);
  while (solved.matching.status == MatchingStatus::no_perfect) {
    TriMesh trial = mesh;
    split_witness(trial, solved.graph, solved.matching);
    Solved next = solve(trial, fields, options, Leave::one_per_odd_part);
    if (next.matching.deficiency >= solved.matching.deficiency) {
      trial = mesh;
      split_ways(trial, solved.matching);
      next = solve(trial, fields, options, Leave::one_per_odd_part);
    }
    LPQ_ASSERT(next.matching.deficiency < solved.matching.deficiency);
    mesh = std::move(trial);
    solved = std::move(next);
  }
  return solved;
}

/// Reads the matching back as what becomes of each triangle.
Pairing read_pairs(const TriMesh& mesh, const Solved& solved, RecombineResult& result) {
  const Index triangles = mesh.triangle_count();
  Pairing pairing;
  pairing.merge.assign(mesh.triangles.size(), none);
  pairing.split.assign(mesh.triangles.size(), none);
  result.pair_of.assign(mesh.triangles.size(), none);
  for (Index t = 0; t < triangles; ++t) {
    const Index mate = solved.matching.mate[t], edge = solved.matching.edge[t];
    if (mate >= triangles) {
      ++result.triangles;
      continue;
    }
    result.pair_of[t] = mate;
    const Index source = solved.graph.source[edge];
    if (edge < solved.graph.merges) {
      pairing.merge[t] = triangle_of(source) == t ? source : mesh.twins[source];
    } else {
      pairing.split[t] = source;
      if (t < mate) ++result.extra_edges;
    }
  }
  return pairing;
}

}  // namespace

RecombineResult recombine(const TriMesh& mesh, const Fields& fields,
                          const RecombineOptions& options) {
  RecombineResult result;
  TriMesh triangulation = mesh;
  prepare_corners(triangulation);
  Solved solved = options.all_quads ? solve_all_quads(triangulation, fields, options)
                                    : solve(triangulation, fields, options, Leave::where_cheaper);
  result.splits = (triangulation.triangle_count() - mesh.triangle_count()) / 2;
  const Pairing pairing = read_pairs(triangulation, solved, result);
  result.mesh = assemble(triangulation, solved.fans, pairing);
  result.cost = solved.matching.cost;
  if (result.triangles > 0) result.status = RecombineStatus::triangles_left;
  if (options.keep_matching) {
    result.triangulation = std::move(triangulation);
    result.graph = std::move(solved.graph.edges);
    result.matching = std::move(solved.matching);
  }
  return result;
}

}  // namespace lpq

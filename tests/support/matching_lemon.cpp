#include "support/matching_lemon.h"

#ifdef LPQ_HAVE_LEMON
#define LEMON_ONLY_TEMPLATES
#include <lemon/matching.h>
#include <lemon/smart_graph.h>
#endif

namespace lpq {
namespace test {

#ifdef LPQ_HAVE_LEMON
LemonAnswer lemon_matching(int node_count, int edge_count, const int* ends,
                           const std::int64_t* costs) {
  lemon::SmartGraph graph;
  graph.reserveNode(node_count);
  graph.reserveEdge(edge_count);
  for (int v = 0; v < node_count; ++v) graph.addNode();
  for (int i = 0; i < edge_count; ++i) {
    graph.addEdge(graph.nodeFromId(ends[2 * i]), graph.nodeFromId(ends[2 * i + 1]));
  }
  typedef lemon::SmartGraph::EdgeMap<std::int64_t> Weights;
  Weights weights(graph);
  for (int i = 0; i < edge_count; ++i) weights[graph.edgeFromId(i)] = -costs[i];
  lemon::MaxWeightedPerfectMatching<lemon::SmartGraph, Weights> matching(graph, weights);
  if (!matching.run()) return {true, false, 0};
  return {true, true, -matching.matchingWeight()};
}
#else
LemonAnswer lemon_matching(int, int, const int*, const std::int64_t*) { return {false, false, 0}; }
#endif

}  // namespace test
}  // namespace lpq

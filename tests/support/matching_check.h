// Solving with every check switched on.
#pragma once

#include <utility>
#include <vector>

#include "catch.h"
#include "matching/blossom.h"
#include "matching/certificate.h"
#include "support/matching_graphs.h"
#include "support/matching_lemon.h"

namespace lpq::test {

inline Matching certified_matching(const MatchingInstance& instance) {
  Matching matching = min_cost_perfect_matching(instance.node_count, instance.edges);
  const std::string fault = check_certificate(instance.node_count, instance.edges, matching);
  if (!fault.empty()) FAIL(fault);
  return matching;
}

/// The node numbers and the order and direction of the edges are shuffled.
inline MatchingInstance relabelled(const MatchingInstance& instance, Rng& rng) {
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[rng.below(i)]);
  };
  std::vector<Index> name(instance.node_count);
  for (Index v = 0; v < instance.node_count; ++v) name[v] = v;
  shuffle(name);
  MatchingInstance result = instance;
  for (CostEdge& e : result.edges) {
    e = {name[e.u], name[e.v], e.cost};
    if (rng.below(2) == 0) std::swap(e.u, e.v);
  }
  shuffle(result.edges);
  return result;
}

inline LemonAnswer lemon_matching(const MatchingInstance& instance) {
  std::vector<int> ends;
  std::vector<std::int64_t> costs;
  for (const CostEdge& e : instance.edges) {
    ends.push_back(e.u);
    ends.push_back(e.v);
    costs.push_back(e.cost);
  }
  return lemon_matching(instance.node_count, static_cast<int>(costs.size()), ends.data(),
                        costs.data());
}

}  // namespace lpq::test

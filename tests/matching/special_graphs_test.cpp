// Empty, odd, infeasible, extreme: graphs at the edges of the contract.
#include "support/matching_check.h"

namespace lpq::test {

TEST_CASE("no nodes, isolated nodes, one edge") {
  const Matching nothing = certified_matching({0, {}});
  CHECK(nothing.status == MatchingStatus::perfect);
  CHECK(nothing.cost == 0);
  const Matching lonely = certified_matching({3, {}});
  CHECK(lonely.status == MatchingStatus::no_perfect);
  CHECK(lonely.deficiency == 3);
  CHECK(lonely.witness.empty());
  const Matching pair = certified_matching({2, {{1, 0, -5}}});
  CHECK(pair.cost == -5);
  CHECK(pair.mate == std::vector<Index>{1, 0});
}

TEST_CASE("the cheapest of parallel edges is used and named") {
  const Matching matching = certified_matching({2, {{0, 1, 7}, {1, 0, 3}, {0, 1, 4}}});
  CHECK(matching.edge == std::vector<Index>{1, 1});
  CHECK(matching.cost == 3);
}

TEST_CASE("bad input is refused") {
  const auto status = [](Index n, std::vector<CostEdge> edges) {
    return min_cost_perfect_matching(n, edges).status;
  };
  CHECK(status(2, {{0, 0, 1}}) == MatchingStatus::invalid_input);
  CHECK(status(2, {{0, 2, 1}}) == MatchingStatus::invalid_input);
  CHECK(status(2, {{-1, 1, 1}}) == MatchingStatus::invalid_input);
  CHECK(status(-1, {}) == MatchingStatus::invalid_input);
  const std::int64_t most = max_matching_cost(2);
  CHECK(status(2, {{0, 1, most}}) == MatchingStatus::perfect);
  CHECK(status(2, {{0, 1, -most}}) == MatchingStatus::perfect);
  CHECK(status(2, {{0, 1, most + 1}}) == MatchingStatus::invalid_input);
  CHECK(status(2, {{0, 1, -most - 1}}) == MatchingStatus::invalid_input);
}

TEST_CASE("a star leaves out all leaves but one, and its hub is the witness") {
  const Index leaves = 20000;
  MatchingInstance star{leaves + 1, {}};
  for (Index v = 1; v <= leaves; ++v) star.edges.push_back({0, v, v % 7});
  const Matching matching = certified_matching(star);
  CHECK(matching.deficiency == leaves - 1);
  CHECK(matching.witness == std::vector<Index>{0});
}

TEST_CASE("triangles hanging on few nodes: odd components with blossoms") {
  Rng rng(11);
  for (int trial = 0; trial < 300; ++trial) {
    const auto hubs = static_cast<Index>(rng.below(4));
    const auto triangles = static_cast<Index>(rng.below(8));
    MatchingInstance instance{hubs + 3 * triangles, {}};
    const auto join = [&](Index u, Index v) {
      instance.edges.push_back({u, v, static_cast<std::int64_t>(rng.below(20)) - 10});
    };
    for (Index t = 0; t < triangles; ++t) {
      const Index a = hubs + 3 * t;
      join(a, a + 1);
      join(a + 1, a + 2);
      join(a + 2, a);
      for (Index hub = 0; hub < hubs; ++hub) join(hub, a + static_cast<Index>(rng.below(3)));
    }
    const Matching matching = certified_matching(relabelled(instance, rng));
    if (hubs == 0) CHECK(matching.deficiency == triangles);
    if (hubs < triangles) CHECK(matching.deficiency >= triangles - hubs);
  }
}

TEST_CASE("a mesh dual with an odd number of triangles leaves one out") {
  MatchingInstance instance = dual_of_grid(5, 60, DualCosts::shape);
  ++instance.node_count;
  instance.edges.push_back({0, instance.node_count - 1, 100});
  const Matching matching = certified_matching(instance);
  CHECK(matching.status == MatchingStatus::no_perfect);
  CHECK(matching.deficiency == 1);
}

TEST_CASE("potentials that outgrow 32 bits: a long path of alternating costs") {
  // The greedy start takes all the cheap inner edges; both ends have to undo it through the path,
  // and duals grow with its length.
  const Index n = 3000;
  const std::int64_t cost = std::int64_t{1} << 20;
  MatchingInstance path{n, {}};
  for (Index v = 0; v + 1 < n; ++v) path.edges.push_back({v, v + 1, v % 2 == 0 ? cost : -cost});
  CHECK(certified_matching(path).cost == n / 2 * cost);
}

TEST_CASE("costs scaled beyond 32 bits give the same matching") {
  const MatchingInstance instance = dual_of_grid(6, 40, DualCosts::shape);
  MatchingInstance scaled = instance;
  for (CostEdge& e : scaled.edges) e.cost *= std::int64_t{1} << 26;
  const Matching matching = certified_matching(instance);
  const Matching wide = certified_matching(scaled);
  CHECK(wide.cost == matching.cost * (std::int64_t{1} << 26));
}

TEST_CASE("the cost does not depend on names, nor the order or direction of edges") {
  Rng rng(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 2 * static_cast<Index>(20 + rng.below(30));
    MatchingInstance instance = random_graph(rng, n, 3 * n, -20, 20);
    for (Index v = 0; v < n; v += 2) instance.edges.push_back({v, v + 1, 30});
    const Matching matching = certified_matching(instance);
    REQUIRE(matching.cost == certified_matching(relabelled(instance, rng)).cost);
  }
}

TEST_CASE("a charge per node moves the cost by the sum of the charges") {
  Rng rng(8);
  const MatchingInstance instance = dual_of_grid(9, 30, DualCosts::uniform);
  MatchingInstance charged = instance;
  std::int64_t sum = 0;
  std::vector<std::int64_t> charge(instance.node_count);
  for (std::int64_t& c : charge) sum += c = static_cast<std::int64_t>(rng.below(20001)) - 10000;
  for (CostEdge& e : charged.edges) e.cost += charge[e.u] + charge[e.v];
  CHECK(certified_matching(charged).cost == certified_matching(instance).cost + sum);
}

TEST_CASE("two runs give the same bits") {
  const MatchingInstance instance = dual_of_grid(10, 50, DualCosts::ties);
  const Matching a = certified_matching(instance), b = certified_matching(instance);
  CHECK(a.mate == b.mate);
  CHECK(a.edge == b.edge);
  CHECK(a.duals.y == b.duals.y);
  CHECK(a.duals.z == b.duals.z);
  CHECK(a.duals.parent == b.duals.parent);
}

}  // namespace lpq::test

// The verifier must refuse everything that is not an optimum with its proof.
#include <functional>

#include "support/matching_check.h"

namespace lpq::test {
namespace {

/// Applies a change to a good answer and expects it to be refused.
void require_refused(const MatchingInstance& instance, const Matching& good,
                     const std::function<void(Matching&)>& change) {
  Matching bad = good;
  change(bad);
  REQUIRE(!check_certificate(instance.node_count, instance.edges, bad).empty());
}

Index first_nested(const MatchingDuals& duals) {
  for (Index b = static_cast<Index>(duals.y.size()); b < static_cast<Index>(duals.parent.size());
       ++b) {
    if (duals.parent[b] != none) return b;
  }
  return none;
}

}  // namespace

TEST_CASE("a corrupted matching is refused") {
  const MatchingInstance instance = dual_of_grid(31, 12, DualCosts::shape);
  const Matching good = certified_matching(instance);
  for (Index v = 0; v < instance.node_count; ++v) {
    require_refused(instance, good, [&](Matching& m) { m.mate[v] = none; });
    require_refused(instance, good, [&](Matching& m) { m.edge[v] = none; });
    require_refused(instance, good, [&](Matching& m) { m.mate[v] = (m.mate[v] + 1) % 100; });
    require_refused(instance, good, [&](Matching& m) { m.edge[v] = (m.edge[v] + 1) % 100; });
    require_refused(instance, good, [&](Matching& m) {
      const Index mate = m.mate[v];
      m.cost -= instance.edges[m.edge[v]].cost;
      m.mate[v] = m.mate[mate] = m.edge[v] = m.edge[mate] = none;
    });
  }
  require_refused(instance, good, [](Matching& m) { ++m.cost; });
  require_refused(instance, good, [](Matching& m) { m.mate.pop_back(); });
  require_refused(instance, good, [](Matching& m) { m.deficiency = 2; });
  require_refused(instance, good, [](Matching& m) { m.status = MatchingStatus::no_perfect; });
  require_refused(instance, good, [](Matching& m) { m.status = MatchingStatus::invalid_input; });
}

TEST_CASE("corrupted duals are refused") {
  const MatchingInstance instance = dual_of_grid(32, 12, DualCosts::uniform);
  const Matching good = certified_matching(instance);
  const auto n = static_cast<std::size_t>(instance.node_count);
  REQUIRE(!good.duals.z.empty());
  for (std::size_t v = 0; v < n; ++v) {
    require_refused(instance, good, [&](Matching& m) { ++m.duals.y[v]; });
    require_refused(instance, good, [&](Matching& m) { --m.duals.y[v]; });
    require_refused(instance, good,
                    [&](Matching& m) { m.duals.y[v] = std::numeric_limits<std::int64_t>::min(); });
    // The sum stays, so only the slack of the matched edge's neighbours can tell.
    require_refused(instance, good, [&](Matching& m) {
      m.duals.y[v] += 100000;
      m.duals.y[(v + 1) % n] -= 100000;
    });
  }
  for (std::size_t b = 0; b < good.duals.z.size(); ++b) {
    require_refused(instance, good, [&](Matching& m) { ++m.duals.z[b]; });
    require_refused(instance, good, [&](Matching& m) { m.duals.z[b] = -m.duals.z[b]; });
    require_refused(instance, good, [&](Matching& m) { m.duals.z[b] = std::int64_t{1} << 62; });
  }
}

TEST_CASE("a family that is not laminar and odd is refused") {
  const MatchingInstance instance = dual_of_grid(33, 16, DualCosts::uniform);
  const Matching good = certified_matching(instance);
  const auto n = static_cast<Index>(good.duals.y.size());
  const auto ids = static_cast<Index>(good.duals.parent.size());
  for (Index v = 0; v < n; ++v) {
    if (good.duals.parent[v] == none) continue;
    require_refused(instance, good, [&](Matching& m) { m.duals.parent[v] = none; });  // even now
    require_refused(instance, good, [&](Matching& m) { m.duals.parent[v] = ids; });
    require_refused(instance, good, [&](Matching& m) { m.duals.parent[v] = v; });
    require_refused(instance, good, [&](Matching& m) { m.duals.parent[v] = -2; });
  }
  const Index nested = first_nested(good.duals);
  REQUIRE(nested != none);
  require_refused(instance, good, [&](Matching& m) { m.duals.parent[nested] = nested; });  // cycles
  require_refused(instance, good,
                  [&](Matching& m) { m.duals.parent[good.duals.parent[nested]] = nested; });
  require_refused(instance, good, [](Matching& m) { m.duals.parent.pop_back(); });
  require_refused(instance, good, [](Matching& m) { m.duals.z.pop_back(); });
  require_refused(instance, good, [](Matching& m) { m.duals = {}; });
}

TEST_CASE("a perfect matching that is not the cheapest is refused whatever the duals") {
  // A square: two perfect matchings, of cost 2 and 4.
  const MatchingInstance square{4, {{0, 1, 1}, {1, 2, 2}, {2, 3, 1}, {3, 0, 2}}};
  const Matching good = certified_matching(square);
  require_refused(square, good, [](Matching& m) {
    m.mate = {3, 2, 1, 0};
    m.edge = {3, 1, 1, 3};
    m.cost = 4;
  });
  require_refused(square, good, [](Matching& m) {
    m.mate = {3, 2, 1, 0};
    m.edge = {3, 1, 1, 3};
    m.cost = 4;
    m.duals.y = {2, 2, 2, 2};
  });
}

TEST_CASE("a witness that proves nothing is refused") {
  MatchingInstance star{6, {{0, 1, 1}, {0, 2, 1}, {0, 3, 1}, {4, 5, 1}}};
  const Matching good = certified_matching(star);
  REQUIRE(good.deficiency == 2);
  require_refused(star, good, [](Matching& m) { m.witness.clear(); });
  require_refused(star, good, [](Matching& m) { m.witness = {1}; });
  require_refused(star, good, [](Matching& m) { m.witness = {0, 0}; });
  require_refused(star, good, [](Matching& m) { m.witness = {6}; });
  require_refused(star, good, [](Matching& m) { m.deficiency = 1; });
}

TEST_CASE("written-out blossoms are odd, nested, and prove the optimum by themselves") {
  const MatchingInstance instance = dual_of_grid(34, 14, DualCosts::uniform);
  const Matching matching = certified_matching(instance);
  const std::vector<OddSet> sets = blossom_sets(matching.duals);
  REQUIRE(sets.size() == matching.duals.z.size());
  std::vector<std::int64_t> slack;
  std::int64_t objective = 0;
  for (const CostEdge& e : instance.edges) {
    slack.push_back(2 * e.cost - matching.duals.y[e.u] - matching.duals.y[e.v]);
  }
  for (const std::int64_t y : matching.duals.y) objective += y;
  for (const OddSet& set : sets) {
    CHECK(set.nodes.size() % 2 == 1);
    CHECK(set.nodes.size() >= 3);
    CHECK(set.z > 0);
    CHECK(std::is_sorted(set.nodes.begin(), set.nodes.end()));
    objective += set.z;
    const auto inside = [&](Index v) {
      return std::binary_search(set.nodes.begin(), set.nodes.end(), v);
    };
    for (std::size_t i = 0; i < slack.size(); ++i) {
      if (inside(instance.edges[i].u) != inside(instance.edges[i].v)) slack[i] -= set.z;
    }
  }
  CHECK(*std::min_element(slack.begin(), slack.end()) == 0);
  CHECK(objective == 2 * matching.cost);
}

TEST_CASE("half units are written exactly") {
  CHECK(half_units_to_decimal(0) == "0");
  CHECK(half_units_to_decimal(3) == "1.5");
  CHECK(half_units_to_decimal(-1) == "-0.5");
  CHECK(half_units_to_decimal(-4) == "-2");
  CHECK(half_units_to_decimal(std::numeric_limits<std::int64_t>::min()) == "-4611686018427387904");
}

TEST_CASE("duals are left out when not asked for") {
  const MatchingInstance instance = dual_of_grid(35, 6, DualCosts::shape);
  const Matching matching =
      min_cost_perfect_matching(instance.node_count, instance.edges, {.duals = false});
  CHECK(matching.duals.y.empty());
  CHECK(matching.cost == certified_matching(instance).cost);
}

}  // namespace lpq::test

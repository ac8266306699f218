// Duals of triangulations, the graphs this solver is for: certified, and equal to LEMON's cost.
#include "support/matching_check.h"

namespace lpq::test {
namespace {

void require_as_lemon(const MatchingInstance& instance) {
  const Matching matching = certified_matching(instance);
  const LemonAnswer lemon = lemon_matching(instance);
  if (!lemon.available) {
    WARN("SKIPPED: comparison with LEMON because it was not found when configuring");
    return;
  }
  REQUIRE((matching.status == MatchingStatus::perfect) == lemon.perfect);
  if (lemon.perfect) REQUIRE(matching.cost == lemon.cost);
}

constexpr DualCosts all_costs[] = {DualCosts::shape, DualCosts::uniform, DualCosts::ties,
                                   DualCosts::heavy_tailed};

}  // namespace

TEST_CASE("duals of small grids, many of them") {
  for (const DualCosts costs : all_costs) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      require_as_lemon(dual_of_grid(seed, static_cast<Index>(2 + seed % 12), costs));
    }
  }
}

TEST_CASE("duals of grids of 5,000 triangles") {
  for (const DualCosts costs : all_costs) require_as_lemon(dual_of_grid(21, 50, costs));
}

TEST_CASE("a nearly regular grid: all costs nearly equal, deep nests of blossoms") {
  require_as_lemon(dual_of_grid(22, 70, DualCosts::shape, 0.01));
  require_as_lemon(dual_of_grid(23, 70, DualCosts::shape, 0));
}

TEST_CASE("random sparse graphs of a thousand nodes, feasible or not") {
  Rng rng(24);
  for (int trial = 0; trial < 40; ++trial) {
    const auto m = static_cast<Index>(1000 + rng.below(3000));
    require_as_lemon(random_graph(rng, 1000, m, -100, 100));
  }
}

TEST_CASE("duals of grids of 200,000 triangles", "[slow]") {
  for (const DualCosts costs : all_costs) require_as_lemon(dual_of_grid(25, 316, costs));
}

}  // namespace lpq::test

// All answers on small graphs against enumeration.
#include "support/matching_check.h"

namespace lpq::test {
namespace {

struct CostRange {
  std::int64_t lo, hi;
};

constexpr CostRange ranges[] = {
    {0, 3},                                             // ties
    {-50, 50},                                          // negative costs
    {0, 10000},                                         // as in meshing
    {-7, -7},                                           // all equal
    {-(std::int64_t{1} << 40), std::int64_t{1} << 40},  // the whole range: 64-bit duals
};

void require_as_enumerated(const MatchingInstance& instance) {
  const EnumeratedMatching truth = enumerate_matchings(instance);
  const Matching matching = certified_matching(instance);
  REQUIRE(matching.deficiency == truth.deficiency);
  REQUIRE((matching.status == MatchingStatus::perfect) == (truth.deficiency == 0));
  if (truth.deficiency == 0) REQUIRE(matching.cost == truth.cost);
}

}  // namespace

TEST_CASE("random graphs of up to 12 nodes agree with enumeration") {
  Rng rng(1);
  for (const CostRange& range : ranges) {
    for (int trial = 0; trial < 5000; ++trial) {
      const auto n = static_cast<Index>(rng.below(13));
      const auto m = static_cast<Index>(rng.below(3 * n + 1));
      require_as_enumerated(random_graph(rng, n, m, range.lo, range.hi));
    }
  }
}

TEST_CASE("random perfect graphs, dense enough to nest blossoms, agree with enumeration") {
  Rng rng(2);
  for (const CostRange& range : ranges) {
    for (int trial = 0; trial < 800; ++trial) {
      const Index n = 8 + 2 * static_cast<Index>(rng.below(3));
      MatchingInstance instance = random_graph(rng, n, 2 * n, range.lo, range.hi);
      for (Index v = 0; v < n; v += 2) instance.edges.push_back({v, v + 1, range.hi});
      require_as_enumerated(instance);
    }
  }
}

TEST_CASE("complete graphs in the plane agree with enumeration") {
  Rng rng(3);
  for (int trial = 0; trial < 500; ++trial) {
    const Index n = 2 * (1 + static_cast<Index>(rng.below(6)));
    std::vector<double> x(n), y(n);
    for (Index v = 0; v < n; ++v) {
      x[v] = rng.unit();
      y[v] = rng.unit();
    }
    MatchingInstance instance{n, {}};
    for (Index u = 0; u < n; ++u) {
      for (Index v = u + 1; v < n; ++v) {
        const double dx = x[u] - x[v], dy = y[u] - y[v];
        instance.edges.push_back(
            {u, v, static_cast<std::int64_t>(1e3 * std::sqrt(dx * dx + dy * dy))});
      }
    }
    require_as_enumerated(instance);
  }
}

}  // namespace lpq::test

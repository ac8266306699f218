// The enumerated fillings of small polygons.
#include <algorithm>
#include <set>

#include "catch.h"
#include "cleanup/disk_patterns.h"
#include "cleanup/ideal_valence.h"

using namespace lpq;

namespace {

using Edge = std::array<int, 2>;

void check_pattern(const DiskPattern& pattern, int loop) {
  const int vertices = loop + pattern.interior;
  // Euler: V - E + F = 1 with 4 F = 2 E - loop.
  REQUIRE(static_cast<int>(pattern.quads.size()) == pattern.interior + loop / 2 - 1);
  std::set<Edge> edges;
  std::vector<int> valence(vertices, 0);
  for (const auto& quad : pattern.quads)
    for (int k = 0; k < 4; ++k) {
      REQUIRE(quad[k] < vertices);
      ++valence[quad[k]];
      REQUIRE(edges.insert({quad[k], quad[(k + 1) % 4]}).second);  // no directed edge twice
    }
  // Unmatched edges are exactly the loop, in its direction.
  for (const Edge& e : edges) {
    const bool inside = edges.count({e[1], e[0]}) > 0;
    REQUIRE(inside == !(e[0] < loop && e[1] == (e[0] + 1) % loop));
  }
  double weight = 0;
  for (int v = 0; v < vertices; ++v) {
    if (v < loop) REQUIRE(valence[v] == pattern.quads_at[v]);
    if (v < loop) continue;
    REQUIRE(valence[v] >= 3);
    weight += irregularity(valence[v], 4, false);
  }
  REQUIRE(weight == pattern.irregularity);
}

}  // namespace

TEST_CASE("every pattern is a quadrangulation of its polygon") {
  for (const PatternSet set : {PatternSet::regular, PatternSet::repair}) {
    DiskPatterns patterns(set);
    for (int loop = 0; loop <= largest_loop; ++loop) {
      double last = 0;
      for (const DiskPattern& pattern : patterns.of_loop(loop)) {
        check_pattern(pattern, loop);
        CHECK(pattern.irregularity >= last);
        last = pattern.irregularity;
      }
    }
    CHECK(patterns.of_loop(7).empty());
    CHECK(patterns.of_loop(40).empty());
    CHECK(patterns.of_loop(none).empty());
  }
}

TEST_CASE("fillings without interior vertices are counted by the ternary trees") {
  // 3, 12, 55 quadrangulations of the hexagon, octagon, decagon (Fuss-Catalan).
  DiskPatterns patterns;
  const int expected[] = {3, 12, 55};
  for (int i = 0; i < 3; ++i) {
    int count = 0;
    for (const DiskPattern& pattern : patterns.of_loop(6 + 2 * i)) count += pattern.interior == 0;
    CHECK(count == expected[i]);
  }
}

TEST_CASE("the set of patterns is closed under rotation and has no doubles") {
  DiskPatterns patterns;
  for (const int loop : {6, 8}) {
    std::multiset<std::vector<int>> counts, turned;
    for (const DiskPattern& pattern : patterns.of_loop(loop)) {
      std::vector<int> row(pattern.quads_at.begin(), pattern.quads_at.begin() + loop);
      counts.insert(row);
      std::rotate(row.begin(), row.begin() + 1, row.end());
      turned.insert(row);
    }
    CHECK(counts == turned);
  }
}

TEST_CASE("one quad can be cut into five") {
  DiskPatterns patterns(PatternSet::repair);
  const auto four = patterns.of_loop(4);
  REQUIRE(four.size() == 2);
  CHECK(four[0].quads.size() == 1);
  CHECK(four[1].quads.size() == 5);
}

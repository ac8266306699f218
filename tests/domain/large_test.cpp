// Inputs of many parts, at which anything quadratic would be seen to hang, and the verdicts on
// them.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "domain/conflicts.h"
#include "domain/domain.h"
#include "domain_shapes.h"
#include "geometry/segment.h"

using namespace lpq;
using namespace lpq_test;

namespace {

constexpr int many = 20'000;

/// n triangles around (0, 0), apart but for that corner.
std::vector<std::vector<Loop>> wheel(int n) {
  std::vector<std::vector<Loop>> regions;
  for (int i = 0; i < n; ++i) {
    const auto rim = [n](double at) {  // on the unit circle
      const double t = 4 * at / n, quarter = std::floor(t), u = t - quarter;
      const Vec2 p{(1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)};
      return quarter == 0   ? p
             : quarter == 1 ? perpendicular(p)
             : quarter == 2 ? -p
                            : -perpendicular(p);
    };
    regions.push_back({{{0, 0}, rim(i + 0.25), rim(i + 0.75)}});
  }
  return regions;
}

ErrorCode code_of(const DomainInput& input) {
  const auto domain = make_domain(input);
  REQUIRE_FALSE(domain.has_value());
  return domain.error().code;
}

}  // namespace

TEST_CASE("holes in a long row are judged one by one") {
  std::vector<Loop> loops{rectangle(-1, -1, 2 * many, 2)};
  for (int i = 0; i < many; ++i) loops.push_back(rectangle(2 * i, 0, 2 * i + 1, 1));
  CHECK(make_domain(one_region(loops)).has_value());
  loops.push_back(rectangle(2 * many - 1.75, 0.25, 2 * many - 1.25, 0.75));
  const auto nested = make_domain(one_region(loops));
  REQUIRE_FALSE(nested.has_value());
  CHECK(nested.error().code == ErrorCode::nested_or_duplicate_hole);
  CHECK(nested.error().where.loop == many + 1);
  CHECK(nested.error().where.other_loop == many);
  loops.back() = rectangle(2 * many + 1, 0, 2 * many + 2, 1);
  CHECK(code_of(one_region(loops)) == ErrorCode::hole_outside);
}

TEST_CASE("regions in a long row, and rings within rings, are judged one by one") {
  std::vector<std::vector<Loop>> row, rings;
  for (int i = 0; i < many; ++i) row.push_back({rectangle(2 * i, 0, 2 * i + 1, 1)});
  const auto domain = make_domain(regions_of(row));
  REQUIRE(domain.has_value());
  CHECK(domain->segments.size() == 4 * row.size());
  for (int i = 1; i < 500; ++i)
    rings.push_back({rectangle(-i, -i, i, i), rectangle(-i + 0.5, -i + 0.5, i - 0.5, i - 0.5)});
  CHECK(make_domain(regions_of(rings)).has_value());
}

TEST_CASE("regions around one corner are judged one by one") {
  auto regions = wheel(many);
  const auto domain = make_domain(regions_of(regions));
  REQUIRE(domain.has_value());
  CHECK(domain->points.size() == 2 * regions.size() + 1);
  CHECK(domain->segments.size() == 3 * regions.size());
  CHECK(meeting_edges(domain->points, domain->segments).empty());

  regions.push_back(regions[many / 3]);  // the same triangle twice
  CHECK(code_of(regions_of(regions)) == ErrorCode::region_conflict);
  for (Vec2& p : regions.back()[0]) p = 0.5 * p;  // within it, its edges along those around
  const auto shorter = make_domain(regions_of(regions));
  REQUIRE_FALSE(shorter.has_value());
  CHECK(shorter.error().code == ErrorCode::overlapping_edges);
  CHECK(shorter.error().where.region == many / 3);
  CHECK(shorter.error().where.edge == 0);
  CHECK(shorter.error().where.other_edge == 0);
}

TEST_CASE("a wheel whose triangles share their spokes has each of them once") {
  auto regions = wheel(1000);
  for (std::size_t i = 0; i < regions.size(); ++i)
    regions[i][0][2] = regions[(i + 1) % regions.size()][0][1];
  const auto domain = make_domain(regions_of(regions));
  REQUIRE(domain.has_value());
  CHECK(domain->segments.size() == 2 * regions.size());
}

TEST_CASE("edges at a busy vertex meet where all pairs say so") {
  Rng rng(3);
  for (int round = 0; round < 20; ++round) {
    // Spokes on a small grid, so that many lie on each other, and some edges beside them.
    std::vector<Vec2> points{{0, 0}};
    for (int x = -4; x <= 4; ++x)
      for (int y = -4; y <= 4; ++y)
        if (x != 0 || y != 0) points.push_back({static_cast<double>(x), static_cast<double>(y)});
    const auto any = [&] { return static_cast<Index>(rng.below(points.size())); };
    std::vector<Segment> edges;
    for (int i = 0; i < 60; ++i) {
      const Index a = i < 40 ? 0 : any(), b = any();
      if (a != b) edges.push_back({.a = a, .b = b});
    }
    std::vector<Index> expected;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto meets = [&](const Segment& e, const Segment& f) {
        const Meeting how = meet(points[e.a], points[e.b], points[f.a], points[f.b]);
        const bool joined = e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b;
        return joined ? how == Meeting::overlapping : how != Meeting::apart;
      };
      for (std::size_t j = 0; j < edges.size(); ++j)
        if (i != j && meets(edges[i], edges[j])) {
          expected.push_back(static_cast<Index>(i));
          break;
        }
    }
    CHECK(meeting_edges(points, edges) == expected);
  }
}

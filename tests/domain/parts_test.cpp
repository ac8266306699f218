// Parts of regions between polylines, on grids whose cells are joined where no line is drawn.
#include "domain/parts.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/disjoint_sets.h"
#include "base/rng.h"
#include "catch.h"
#include "domain/boundary.h"
#include "domain/division.h"
#include "domain_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

constexpr Index n = 7;  // cells along each side

struct Grid {
  DomainInput input;
  DisjointSets cells{n * n};
};

// An affine map, so that lines have all directions, and the grid's corners after it.
Vec2 at(Index x, Index y) { return {1.0 * x + 0.25 * y, 1.0 * y - 0.375 * x}; }

/// Every inner edge of the grid is drawn with this probability, the rest join the cells beside it.
Grid random_grid(std::uint64_t seed, double drawn) {
  Rng rng(seed);
  Grid grid;
  Loop loop;
  for (Index k = 0; k < n; ++k) loop.push_back(at(k, 0));
  for (Index k = 0; k < n; ++k) loop.push_back(at(n, k));
  for (Index k = n; k > 0; --k) loop.push_back(at(k, n));
  for (Index k = n; k > 0; --k) loop.push_back(at(0, k));
  grid.input = one_region({loop});
  const auto line = [&](Vec2 a, Vec2 b, Index one, Index two) {
    if (rng.unit() < drawn)
      grid.input.polylines.push_back({{a, b}, ""});
    else
      grid.cells.unite(one, two);
  };
  for (Index y = 0; y < n; ++y)
    for (Index x = 1; x < n; ++x) {
      line(at(x, y), at(x, y + 1), y * n + x - 1, y * n + x);
      line(at(y, x), at(y + 1, x), (x - 1) * n + y, x * n + y);
    }
  return grid;
}

/// The cell of the grid beside the middle of a segment, to its left; none outside.
Index cell_left_of(const Domain& domain, Index a, Index b) {
  const Vec2 p = domain.frame.to_world(domain.points[a]),
             q = domain.frame.to_world(domain.points[b]);
  const Vec2 beside = midpoint(p, q) + 0.1 * perpendicular(q - p);
  const double det = 1 + 0.25 * 0.375;  // of the affine map
  const double x = (beside.x - 0.25 * beside.y) / det, y = (beside.y + 0.375 * beside.x) / det;
  if (x < 0 || y < 0 || x > n || y > n) return none;
  return static_cast<Index>(y) * n + static_cast<Index>(x);
}

}  // namespace

TEST_CASE("parts are the cells that no line divides") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Grid grid = random_grid(seed, 0.1 + 0.08 * static_cast<double>(seed % 10));
    const auto domain = make_domain(grid.input);
    REQUIRE(domain.has_value());
    const Parts parts = find_parts(domain->points, domain->segments);
    std::map<Index, Index> part_of;  // root of the cells -> part
    std::set<Index> found;
    const auto check_side = [&](Index part, Index cell) {
      CHECK((part == none) == (cell == none));
      if (cell == none) return;
      const auto known = part_of.emplace(grid.cells.root(cell), part).first;
      CHECK(known->second == part);
      found.insert(part);
    };
    for (const Segment& s : parts.segments) {
      check_side(s.left, cell_left_of(*domain, s.a, s.b));
      check_side(s.right, cell_left_of(*domain, s.b, s.a));
    }
    CHECK(part_of.size() == found.size());
    CHECK(parts.count() == static_cast<Index>(found.size()));
    for (const Index region : parts.region) CHECK(region == 0);
  }
}

TEST_CASE("without polylines every region is a part") {
  const Loop inner{{4, 4}, {6, 4}, {5, 6}};
  const auto domain = make_domain(regions_of({{rectangle(0, 0, 10, 10), inner}, {inner}}));
  REQUIRE(domain.has_value());
  const Parts parts = find_parts(domain->points, domain->segments);
  CHECK(parts.region == std::vector<Index>{0, 1});
  for (std::size_t i = 0; i < parts.segments.size(); ++i) {
    CHECK(parts.segments[i].left == domain->segments[i].left);
    CHECK(parts.segments[i].right == domain->segments[i].right);
  }
}

TEST_CASE("every part between lines gets an even count") {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const bool keep : {true, false}) {
      const Grid grid = random_grid(seed, 0.5);
      const auto domain = make_domain(grid.input);
      REQUIRE(domain.has_value());
      const auto mesh = sample_boundary(
          *domain, {.keep = keep, .size = 0.045, .growth = 0.3, .allow_added_point = true});
      REQUIRE(mesh.has_value());
      const Parts parts = find_parts(mesh->points, mesh->edges);
      const std::vector<Index> one(mesh->edges.size(), 1);
      for (const Index count : boundary_counts(parts.segments, parts.count(), one))
        CHECK(count % 2 == 0);
    }
}

TEST_CASE("an odd part is refused where it is") {
  auto input = one_region({{{0, 0}, {4, 0}, {4, 1}, {4, 2}, {4, 4}, {0, 4}}});
  input.polylines.push_back({{{0, 0}, {4, 1}}, ""});  // a triangle below, five edges above
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  const auto refused = sample_boundary(*domain, {.keep = true});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().code == ErrorCode::odd_boundary);
  CHECK(refused.error().message.find("A part of the domain") == 0);
  CHECK(refused.error().where.region == 0);
  // The longest edge that helps both: a point there, and the counts are even.
  const Vec2 place = domain->frame.to_world({refused.error().where.x, refused.error().where.y});
  REQUIRE(refused.error().where.has_point);
  CHECK((place == Vec2{2, 0} || place == Vec2{0, 2} || place == Vec2{2, 4}));
  const auto allowed = sample_boundary(*domain, {.keep = true, .require_even = false});
  REQUIRE(allowed.has_value());
  CHECK(allowed->points.size() == 6);
}

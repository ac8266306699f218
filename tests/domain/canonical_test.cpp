// The domain's arrays do not depend on how the caller wrote the loops down.
#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "domain/boundary.h"
#include "domain_data.h"
#include "domain_shapes.h"
#include "geometry/polygon.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainInput shuffled(DomainInput input, Rng& rng) {
  for (auto& region : input.regions) {
    for (std::size_t i = region.loops.size(); i > 1; --i)
      std::swap(region.loops[i - 1], region.loops[rng.below(i)]);
    for (Loop& loop : region.loops) {
      if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
      std::rotate(loop.begin(), loop.begin() + rng.below(loop.size()), loop.end());
      if (rng.below(2) == 0) std::reverse(loop.begin(), loop.end());
    }
  }
  return input;
}

void check_same(const Domain& one, const Domain& two, double scale) {
  REQUIRE(one.points.size() == two.points.size());
  REQUIRE(one.segments.size() == two.segments.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    REQUIRE(one.points[i] == two.points[i]);
    REQUIRE(scale * one.given[i] == two.given[i]);
  }
  for (std::size_t i = 0; i < one.segments.size(); ++i) {
    REQUIRE(one.segments[i].a == two.segments[i].a);
    REQUIRE(one.segments[i].b == two.segments[i].b);
    REQUIRE(one.segments[i].left == two.segments[i].left);
  }
  CHECK(std::abs(one.area - two.area) <= 1e-15);
}

}  // namespace

TEST_CASE("loop order, orientation and start do not matter") {
  Rng rng(1);
  std::vector<DomainInput> inputs{square_with_holes()};
  const auto files = shared_domains("polygons");
  for (std::size_t i = 0; i < files.size(); i += 7) inputs.push_back(read_domain(files[i]));
  for (const DomainInput& input : inputs) {
    const auto first = make_domain(input);
    REQUIRE(first.has_value());
    for (int round = 0; round < 3; ++round) {
      const auto again = make_domain(shuffled(input, rng));
      REQUIRE(again.has_value());
      check_same(*first, *again, 1);
    }
  }
}

TEST_CASE("scaling by a power of two changes nothing in the unit frame") {
  for (const int exponent : {-40, -3, 5, 40}) {
    const double scale = std::ldexp(1.0, exponent);
    auto input = square_with_holes();
    for (Loop& loop : input.regions[0].loops)
      for (Vec2& p : loop) p = scale * p;
    check_same(*make_domain(square_with_holes()), *make_domain(input), scale);
  }
}

TEST_CASE("far from the origin every given bit survives") {
  auto input = square_with_holes();
  for (Loop& loop : input.regions[0].loops)
    for (Vec2& p : loop) p = p + Vec2{1e9 + 0.1, -3e9 + 0.7};
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  for (std::size_t i = 0; i < domain->points.size(); ++i)
    CHECK(domain->frame.to_world(domain->points[i]) == domain->given[i]);
}

TEST_CASE("tags stay with their edges and points with their rank") {
  auto input = square_with_holes();
  input.regions[0].tags = {{"south", "east", "north", "west"}};
  std::reverse(input.regions[0].loops[0].begin(), input.regions[0].loops[0].end());
  input.regions[0].tags[0] = {"north", "east", "south", "west"};
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  CHECK(domain->tags == std::vector<std::string>{"east", "north", "south", "west"});
  for (const Segment& s : domain->segments) {
    if (s.tag == none) continue;
    const Vec2 m = midpoint(domain->given[s.a], domain->given[s.b]);
    const std::string expected = m.y == 0    ? "south"
                                 : m.y == 10 ? "north"
                                 : m.x == 0  ? "west"
                                             : "east";
    CHECK(domain->tags[s.tag] == expected);
    CHECK(s.reversed);
  }
  std::vector<Vec2> in_order(domain->given.size());
  for (std::size_t i = 0; i < in_order.size(); ++i)
    in_order[domain->output_rank[i]] = domain->given[i];
  std::size_t next = 0;
  for (const Loop& loop : input.regions[0].loops)
    for (const Vec2 p : loop) CHECK(in_order[next++] == p);
}

TEST_CASE("outer loops run counter-clockwise, holes clockwise, the region on the left") {
  const auto domain = make_domain(square_with_holes());
  double area = 0;
  for (const Segment& s : domain->segments) {
    CHECK(s.left == 0);
    CHECK(s.right == none);
    area += 0.5 * cross(domain->given[s.a], domain->given[s.b]);
  }
  CHECK(area == Approx(100 - 2 - 1.75));
  CHECK(domain->area * std::pow(1 / domain->frame.scale, 2) == Approx(area));
}

TEST_CASE("the sign of an area is exact") {
  // Collinear up to the last bit: the rounded area is noise.
  const std::vector<Vec2> thin{{0.1, 0.1}, {0.3, 0.3}, {0.7, std::nextafter(0.7, 1.0)}};
  CHECK(orientation(thin) == 1);
  CHECK(orientation(std::vector<Vec2>{thin.rbegin(), thin.rend()}) == -1);
  CHECK(orientation(std::vector<Vec2>{{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}, {0.5, 0.5}}) == 0);
}

TEST_CASE("a million edges pass the door in seconds", "[slow]") {
  Loop loop;
  Rng rng(5);
  const int n = 1000000;
  for (int i = 0; i < n; ++i) {
    // A staircase ring that is simple by construction: one corner per column, out and back.
    const bool out = i < n / 2;
    const double x = out ? i : n - 1 - i;
    loop.push_back({x, (out ? 0.0 : 10.0) + rng.unit()});
  }
  const auto domain = make_domain(one_region({loop}));
  CHECK(domain.has_value());
}

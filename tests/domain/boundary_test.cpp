// The 1D mesh in both modes: what it keeps, what it adds, and that the counts are even.
#include "domain/boundary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "catch.h"
#include "domain/conflicts.h"
#include "domain_data.h"
#include "domain_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

std::vector<Index> counts(const BoundaryMesh& mesh, std::size_t regions) {
  std::vector<Index> result(regions, 0);
  for (const Segment& e : mesh.edges) {
    if (e.left == e.right) continue;
    for (const Index side : {e.left, e.right})
      if (side != none) ++result[side];
  }
  return result;
}

/// What holds for every 1D mesh of a domain.
void check_mesh(const Domain& domain, const BoundaryMesh& mesh) {
  for (const Index count : counts(mesh, domain.regions.size())) CHECK(count % 2 == 0);
  std::vector<char> present(domain.points.size(), 0), ranked(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    REQUIRE_FALSE(ranked[mesh.output_rank[v]]);
    ranked[mesh.output_rank[v]] = 1;
    REQUIRE(domain.frame.to_frame(mesh.world[v]) == mesh.points[v]);
    if (mesh.source[v] == none) continue;
    present[mesh.source[v]] = 1;
    REQUIRE(mesh.world[v] == domain.given[mesh.source[v]]);
  }
  CHECK(std::count(present.begin(), present.end(), 0) == 0);
  CHECK(meeting_edges(mesh.points, mesh.edges).empty());
  double area = 0;
  for (const Segment& e : mesh.edges) {
    const double sides = (e.left != none ? 1 : 0) - (e.right != none ? 1 : 0);
    area += 0.5 * sides * cross(mesh.points[e.a], mesh.points[e.b]);
  }
  CHECK(std::abs(area - domain.area) < 1e-11);
}

/// Neighbouring pieces of one straight edge differ by the growth, and none is longer than asked.
void check_grading(const BoundaryMesh& mesh, const BoundaryOptions& options) {
  const double slack = 2.0;  // counts are whole numbers: N = 1.49 becomes one piece
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const Segment& e = mesh.edges[i];
    const double l = distance(mesh.points[e.a], mesh.points[e.b]);
    REQUIRE(l <= 1.6 * options.size);
    if (i == 0 || mesh.source[e.a] != none) continue;
    const Segment& f = mesh.edges[i - 1];
    const double k = distance(mesh.points[f.a], mesh.points[f.b]);
    REQUIRE(std::max(l, k) <= (1 + slack * options.growth) * std::min(l, k));
  }
}

}  // namespace

TEST_CASE("kept mode returns the given points and names an odd region") {
  const auto domain = make_domain(square_with_holes());
  const auto mesh = sample_boundary(*domain);
  REQUIRE_FALSE(mesh.has_value());
  CHECK(mesh.error().code == ErrorCode::odd_boundary);
  CHECK(mesh.error().where.region == 0);
  CHECK(mesh.error().message.find("11") != std::string::npos);

  const auto triangles_allowed = sample_boundary(*domain, {.require_even = false});
  REQUIRE(triangles_allowed.has_value());
  CHECK(triangles_allowed->points.size() == 11);

  const auto cured = sample_boundary(*domain, {.allow_added_point = true});
  REQUIRE(cured.has_value());
  REQUIRE(cured->warnings.size() == 1);
  CHECK(cured->warnings[0].code == ErrorCode::odd_boundary);
  const Where& where = cured->warnings[0].where;
  REQUIRE(where.has_point);
  CHECK(std::count(cured->world.begin(), cured->world.end(), Vec2{where.x, where.y}) == 1);
  CHECK(cured->points.size() == 12);
  check_mesh(*domain, *cured);
}

TEST_CASE("an enclosed odd region is cured through its neighbours") {
  // A triangle in the triangular hole of a square: only its own border can be divided.
  const Loop inner{{4, 4}, {6, 4}, {5, 6}};
  const auto domain = make_domain(regions_of({{rectangle(0, 0, 10, 10), inner}, {inner}}));
  REQUIRE(domain.has_value());
  const auto mesh = sample_boundary(*domain, {.allow_added_point = true});
  REQUIRE(mesh.has_value());
  CHECK(mesh->warnings.size() == 1);
  check_mesh(*domain, *mesh);
}

TEST_CASE("every region of a row of odd regions gets an even count") {
  // A fan of triangles round a point, all enclosed by a frame.
  std::vector<std::vector<Loop>> regions;
  const Loop ring{{4, 4}, {6, 4}, {7, 6}, {5, 7}, {3, 6}};
  regions.push_back({rectangle(0, 0, 10, 10), ring});
  for (std::size_t i = 0; i < ring.size(); ++i)
    regions.push_back({{{5, 5}, ring[i], ring[(i + 1) % ring.size()]}});
  const auto domain = make_domain(regions_of(regions));
  REQUIRE(domain.has_value());
  for (const bool keep : {true, false}) {
    const auto mesh =
        sample_boundary(*domain, {.keep = keep, .size = 0.3, .allow_added_point = true});
    REQUIRE(mesh.has_value());
    check_mesh(*domain, *mesh);
  }
}

TEST_CASE("refined nodes follow the given order along the given edges") {
  auto input = one_region({rectangle(0, 0, 10, 10)});
  std::reverse(input.regions[0].loops[0].begin(), input.regions[0].loops[0].end());
  const auto domain = make_domain(input);
  const auto mesh = sample_boundary(*domain, {.keep = false, .size = 0.1});
  REQUIRE(mesh.has_value());
  std::vector<Vec2> in_order(mesh->points.size());
  for (std::size_t v = 0; v < in_order.size(); ++v) in_order[mesh->output_rank[v]] = mesh->world[v];
  CHECK(in_order[0] == input.regions[0].loops[0][0]);
  double length_walked = 0;
  for (std::size_t v = 0; v < in_order.size(); ++v)
    length_walked += distance(in_order[v], in_order[(v + 1) % in_order.size()]);
  CHECK(length_walked == Approx(40));
  const Vec2 second = in_order[1];
  CHECK(second.y == 10);  // the first edge as given runs along the top
}

TEST_CASE("equal pieces where nothing asks for grading") {
  const auto domain = make_domain(one_region({rectangle(0, 0, 8, 8)}));
  const auto mesh = sample_boundary(*domain, {.keep = false, .size = 0.05});
  REQUIRE(mesh.has_value());
  const double first = distance(mesh->points[mesh->edges[0].a], mesh->points[mesh->edges[0].b]);
  for (const Segment& e : mesh->edges)
    CHECK(distance(mesh->points[e.a], mesh->points[e.b]) == Approx(first));
}

TEST_CASE("edges are as short as sizes given near them ask for") {
  const auto domain = make_domain(one_region({rectangle(0, 0, 8, 8)}));
  const UnitFrame& frame = domain->frame;
  BoundaryOptions options{.keep = false, .size = frame.length_to_frame(0.5), .growth = 0.2};
  const auto plain = sample_boundary(*domain, options);
  // On an edge, in a corner, inside; the last two are coarser than what is there anyway.
  const std::vector<std::pair<Vec2, double>> given{
      {{3, 0}, 0.02}, {{8, 8}, 0.05}, {{2, 6.5}, 0.1}, {{1, 1}, 2.0}, {{4, 4}, 0.4}};
  for (const auto& [position, h] : given)
    options.sizes.push_back({frame.to_frame(position), frame.length_to_frame(h)});
  const auto mesh = sample_boundary(*domain, options);
  REQUIRE(mesh.has_value());
  check_mesh(*domain, *mesh);
  CHECK(mesh->edges.size() > plain->edges.size() + 30);
  for (const Segment& e : mesh->edges) {
    const Vec2 a = mesh->world[e.a], b = mesh->world[e.b];
    double asked = 0.5;
    for (const auto& [position, h] : given)
      asked = std::min(asked, h + options.growth * distance(midpoint(a, b), position));
    CHECK(distance(a, b) < 1.2 * asked);
    CHECK(distance(a, b) > 0.7 * asked);
  }
}

TEST_CASE("across a narrow gap edges are no longer than about the gap") {
  // A slit of width 0.01 between two long walls.
  const auto domain = make_domain(one_region({rectangle(0, 0, 10, 4), rectangle(1, 0.01, 9, 2)}));
  const BoundaryOptions options{.keep = false, .size = 0.1};
  const auto mesh = sample_boundary(*domain, options);
  REQUIRE(mesh.has_value());
  check_mesh(*domain, *mesh);
  for (const Segment& e : mesh->edges) {
    const Vec2 a = mesh->world[e.a], b = mesh->world[e.b];
    const bool in_slit =
        std::max(a.y, b.y) <= 0.01 && std::min(a.x, b.x) > 1.5 && std::max(a.x, b.x) < 8.5;
    if (in_slit) CHECK(distance(a, b) < 2.5 * 0.01);
  }
}

TEST_CASE("a needle costs a few nodes, not as many as its angle is small") {
  const auto domain = make_domain(one_region({{{0, 0}, {10, 0}, {10, 1e-4}}}));
  const auto mesh = sample_boundary(*domain, {.keep = false, .size = 0.1});
  REQUIRE(mesh.has_value());
  CHECK(mesh->points.size() < 200);
}

TEST_CASE("sizes that are none, and too many nodes, are refused before the work") {
  const auto domain = make_domain(square_with_holes());
  for (const double size : {0.0, -1.0, std::nan("")})
    CHECK(sample_boundary(*domain, {.keep = false, .size = size}).error().code ==
          ErrorCode::bad_size);
  const auto mesh = sample_boundary(*domain, {.keep = false, .size = 1e-9});
  REQUIRE_FALSE(mesh.has_value());
  CHECK(mesh.error().code == ErrorCode::too_many_elements);
}

TEST_CASE("a size beyond the domain keeps the corners") {
  const auto domain = make_domain(one_region({{{0, 0}, {1, 0}, {0.4, 0.8}}}));
  const auto mesh = sample_boundary(*domain, {.keep = false, .size = 100});
  REQUIRE(mesh.has_value());
  check_mesh(*domain, *mesh);
}

TEST_CASE("simplifying stays within its tolerance and keeps the topology") {
  std::vector<DomainInput> inputs;
  // A wavy wall close to a small hole, which the straightened wall would cut off.
  Loop wavy{{10, 10}, {0, 10}};
  for (int i = 0; i <= 100; ++i) wavy.push_back({0.1 * i, 0.2 * std::sin(0.3 * i)});
  inputs.push_back(one_region({wavy, rectangle(7.75, -0.1, 7.85, -0.08)}));
  const auto files = shared_domains("polygons");
  for (std::size_t i = 0; i < files.size(); i += 3) inputs.push_back(read_domain(files[i]));
  for (const DomainInput& input : inputs) {
    const auto domain = make_domain(input);
    REQUIRE(domain.has_value());
    if (domain->points.size() > 4000) continue;
    for (const double tolerance : {1e-3, 0.05, 1.0}) {
      const BoundaryOptions options{.keep = false, .size = 0.2, .simplify_tolerance = tolerance};
      const auto mesh = sample_boundary(*domain, options);
      REQUIRE(mesh.has_value());
      CHECK(mesh->simplify_deviation <= tolerance);
      CHECK(meeting_edges(mesh->points, mesh->edges).empty());
      CHECK(counts(*mesh, 1)[0] % 2 == 0);
      CHECK(std::count(mesh->source.begin(), mesh->source.end(), none) <
            static_cast<std::ptrdiff_t>(mesh->points.size()));
      // Read back as a domain of its own, it has the same loops.
      DomainInput again;
      again.regions.emplace_back();
      std::vector<Index> next(mesh->points.size(), none);
      for (const Segment& e : mesh->edges) next[e.a] = e.b;
      for (std::size_t v = 0; v < next.size(); ++v) {
        Loop loop;
        for (Index w = static_cast<Index>(v); next[w] != none;) {
          loop.push_back(mesh->points[w]);
          w = std::exchange(next[w], none);
        }
        if (!loop.empty()) again.regions[0].loops.push_back(loop);
      }
      CHECK(again.regions[0].loops.size() == input.regions[0].loops.size());
      const auto judged = make_domain(again);
      INFO((judged ? std::string() : judged.error().message));
      CHECK(judged.has_value());
    }
  }
}

TEST_CASE("simplifying keeps tags, tagged points and common borders of regions") {
  auto input = one_region({{{0, 0}, {5, 0.001}, {10, 0}, {10, 10}, {5, 9.999}, {0, 10}}});
  input.regions[0].tags = {{"a", "b", "", "", "", ""}};
  const auto domain = make_domain(input);
  const auto mesh = sample_boundary(
      *domain, {.keep = false, .size = 2, .simplify_tolerance = 0.01, .require_even = false});
  REQUIRE(mesh.has_value());
  const auto given =
      mesh->points.size() - std::count(mesh->source.begin(), mesh->source.end(), none);
  CHECK(given == 5);  // the corner between a and b stays, the one on top goes
  CHECK(mesh->simplify_deviation > 0);
}

TEST_CASE("every shared domain can be refined, coarse and fine") {
  for (const auto& path : shared_domains("polygons")) {
    INFO(path.filename());
    const auto domain = make_domain(read_domain(path));
    REQUIRE(domain.has_value());
    if (domain->points.size() > 2000) continue;
    for (const double size : {2.0, 0.05}) {
      const BoundaryOptions options{.keep = false, .size = size};
      const auto mesh = sample_boundary(*domain, options);
      REQUIRE(mesh.has_value());
      check_mesh(*domain, *mesh);
      check_grading(*mesh, options);
    }
  }
}

TEST_CASE("the largest shared domains can be refined", "[slow]") {
  for (const auto& path : shared_domains("polygons")) {
    const auto domain = make_domain(read_domain(path));
    REQUIRE(domain.has_value());
    if (domain->points.size() <= 2000) continue;
    INFO(path.filename());
    const auto mesh = sample_boundary(*domain, {.keep = false, .size = 0.02});
    REQUIRE(mesh.has_value());
    check_mesh(*domain, *mesh);
  }
}

// Geographic coordinates: a unit in the last place is 10^-12 of the domain's size.
TEST_CASE("far from the origin nodes are placed where the coordinates meet the segment") {
  DomainInput input;
  input.regions.push_back(
      {"", {{{114.1841, 22.2651}, {114.1907, 22.2667}, {114.1883, 22.2703}}}, {}});
  const auto domain = make_domain(input);
  REQUIRE(domain.has_value());
  const auto mesh = sample_boundary(*domain, {.keep = false, .size = 0.05});
  REQUIRE(mesh.has_value());
  REQUIRE(mesh->points.size() > 20);
  const double diagonal = 0.75;  // of the unit frame, at least
  for (const Segment& e : mesh->edges) {
    const auto side =
        std::find_if(domain->segments.begin(), domain->segments.end(), [&](const Segment& s) {
          return s.region == e.region && s.loop == e.loop && s.edge == e.edge;
        });
    REQUIRE(side != domain->segments.end());
    const Vec2 a = domain->points[side->a], b = domain->points[side->b];
    for (const Index v : {e.a, e.b})
      CHECK(std::abs(cross(mesh->points[v] - a, b - a)) / distance(a, b) < 1e-12 * diagonal);
  }
}

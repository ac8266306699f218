// Several regions, constraint polylines and points, tags: carried through, never crossed.
#include <algorithm>
#include <map>

#include "catch.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

// Every edge of the 1D mesh must be an edge of the face mesh.
void require_edges_present(const OutputMesh& mesh) {
  std::map<std::pair<Index, Index>, int> sides;
  for (const Face& face : mesh.faces)
    for (int k = 0, n = corner_count(face); k < n; ++k) {
      const Index a = face[k], b = face[(k + 1) % n];
      ++sides[{std::min(a, b), std::max(a, b)}];
    }
  for (const OutputEdge& e : mesh.edges)
    CHECK(sides[{std::min(e.a, e.b), std::max(e.a, e.b)}] == (e.left != none) + (e.right != none));
}

}  // namespace

TEST_CASE("two regions that share an edge chain stay conforming") {
  DomainInput input;  // eighths are exact, so both regions name the same points on x = 1
  input.regions.push_back({"left", {sampled_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.125)}, {}});
  input.regions.push_back(
      {"right", {sampled_polygon({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, 0.125)}, {}});
  const auto outcome = mesh_domain(input, {.keep_boundary = true});
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.quality.triangles == 0);
  CHECK(outcome->mesh.regions == std::vector<std::string>{"left", "right"});
  require_edges_present(outcome->mesh);
  for (std::size_t f = 0; f < outcome->mesh.faces.size(); ++f)
    for (const Index v : outcome->mesh.faces[f]) {
      const double x = outcome->mesh.points[v].x;
      CHECK((outcome->mesh.region[f] == 0 ? x <= 1 : x >= 1));
    }
}

TEST_CASE("a region may fill another's hole") {
  DomainInput input;
  const Loop ring = circle({0.5, 0.5}, 0.25, 0.08);
  input.regions.push_back(
      {"matrix", {sampled_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.08), ring}, {}});
  input.regions.push_back({"inclusion", {ring}, {}});
  const auto outcome = mesh_domain(input, {.keep_boundary = true});
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.quality.triangles == 0);
  require_edges_present(outcome->mesh);
}

TEST_CASE("separate parts are meshed together") {
  DomainInput input;
  input.regions.push_back({"a", {sampled_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.2)}, {}});
  input.regions.push_back({"b", {sampled_polygon({{3, 0}, {4, 0}, {4, 1}, {3, 1}}, 0.2)}, {}});
  const auto outcome = mesh_domain(input, {.keep_boundary = true});
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.quality.quads == 50);
}

TEST_CASE("polylines become mesh edges, points become mesh vertices, tags survive") {
  DomainInput input = square(1, 0.1);
  DomainInput::Polyline crack;
  crack.tag = "crack";
  for (int i = 0; i <= 4; ++i) crack.points.push_back({0.3 + 0.1 * i, 0.5});
  input.polylines.push_back(crack);
  input.points.push_back({{0.71, 0.82}, "sensor"});
  const auto outcome = mesh_domain(input, {.keep_boundary = true});
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.quality.triangles == 0);
  require_edges_present(outcome->mesh);
  const auto tagged = std::count_if(outcome->mesh.edges.begin(), outcome->mesh.edges.end(),
                                    [&](const OutputEdge& e) { return e.tag != none; });
  CHECK(tagged == 4);
  REQUIRE(outcome->mesh.tagged_points.size() == 1);
  CHECK(outcome->mesh.points[outcome->mesh.tagged_points[0].point] == Vec2{0.71, 0.82});
}

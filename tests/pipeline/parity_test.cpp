// Odd numbers of boundary edges: quads alone cannot fill such a part; one triangle more can.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const Options one_triangle{.keep_boundary = true, .elements = Elements::one_triangle};

DomainInput without_point(DomainInput input, std::size_t i) {
  Loop& loop = input.regions[0].loops.back();
  loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
  return input;
}

DomainInput with_midpoint(DomainInput input, std::size_t i) {
  Loop& loop = input.regions[0].loops[0];
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, midpoint(loop[i], loop[i + 1]));
  return input;
}

std::vector<Face> triangles_of(const OutputMesh& mesh) {
  std::vector<Face> result;
  std::copy_if(mesh.faces.begin(), mesh.faces.end(), std::back_inserter(result),
               [](const Face& face) { return corner_count(face) == 3; });
  return result;
}

Index warnings_of(const Report& report, ErrorCode code) {
  return static_cast<Index>(std::count_if(report.warnings.begin(), report.warnings.end(),
                                          [&](const Warning& w) { return w.code == code; }));
}

void require_one_triangle(const DomainInput& input, const Outcome& outcome) {
  REQUIRE(check_output(outcome.mesh).empty());
  std::size_t node = 0;
  for (const Loop& loop : input.regions[0].loops)
    for (const Vec2 p : loop) CHECK(outcome.mesh.points[node++] == p);
  CHECK(outcome.mesh.fixed == static_cast<Index>(node));
  CHECK(outcome.report.quality.triangles == 1);
  const std::vector<Face> triangles = triangles_of(outcome.mesh);
  REQUIRE(triangles.size() == 1);
  CHECK(face_eta(outcome.mesh.points, triangles[0]) > 0.5);
  // The report says where.
  CHECK(warnings_of(outcome.report, ErrorCode::odd_boundary) == 1);
  const Warning& told = outcome.report.warnings.back();
  const Vec2 centre = centre_of(outcome.mesh.points, triangles[0]);
  CHECK(told.where.region == 0);
  CHECK((told.where.x == centre.x && told.where.y == centre.y));
}

}  // namespace

TEST_CASE("one triangle is left where the count is odd, and shapes hardly suffer") {
  const DomainInput shapes[] = {square(1, 0.06), l_shape(0.06),         disc(0.1),
                                annulus(0.08),   plate_with_hole(0.08), hood(0.08)};
  for (const DomainInput& shape : shapes)
    for (const DomainInput& input : {without_point(shape, 5), with_midpoint(shape, 3)}) {
      const auto outcome = mesh_domain(input, one_triangle);
      REQUIRE(outcome);
      require_one_triangle(input, *outcome);
      CHECK(outcome->report.attempts == 1);
      const auto even = mesh_domain(shape, one_triangle);
      REQUIRE(even);
      CHECK(outcome->report.quality.eta_mean > even->report.quality.eta_mean - 0.04);
      CHECK(outcome->report.quality.eta_min > 0.5);
    }
}

TEST_CASE("the paper's chain and much effort leave one triangle, too") {
  const DomainInput input = without_point(plate_with_hole(0.12), 4);
  Options options = one_triangle;
  options.effort = Effort::high;
  const auto high = mesh_domain(input, options);
  REQUIRE(high);
  require_one_triangle(input, *high);
  options = one_triangle;
  options.method = Method::paper;
  const auto paper = mesh_domain(input, options);
  REQUIRE(paper);
  require_one_triangle(input, *paper);
}

TEST_CASE("where the count is even no triangle is left, and the mesh is that of quads alone") {
  for (const DomainInput& input : {disc(0.1), plate_with_hole(0.08)}) {
    const auto outcome = mesh_domain(input, one_triangle);
    REQUIRE(outcome);
    CHECK(outcome->report.quality.triangles == 0);
    CHECK(warnings_of(outcome->report, ErrorCode::odd_boundary) == 0);
    CHECK(outcome->report.hash == mesh_domain(input, {.keep_boundary = true})->report.hash);
  }
  // A boundary that may be divided has an even count.
  const DomainInput odd = domain_of({{{0, 0}, {3, 0}, {3, 1}, {1.4, 2}, {0, 1}}});
  const auto refined = mesh_domain(odd, {.size = 0.3, .elements = Elements::one_triangle});
  REQUIRE(refined);
  CHECK(refined->report.quality.triangles == 0);
}

TEST_CASE("what was repaired at the door is told once") {
  const auto outcome = mesh_domain(domain_of({{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}}), {});
  REQUIRE(outcome);
  CHECK(warnings_of(outcome->report, ErrorCode::duplicate_point) == 1);
}

TEST_CASE("an added point is preferred where both it and a triangle are allowed") {
  Options options = one_triangle;
  options.allow_added_point = true;
  const auto outcome = mesh_domain(with_midpoint(square(1, 0.1), 2), options);
  REQUIRE(outcome);
  CHECK(outcome->report.quality.triangles == 0);
  CHECK(outcome->mesh.fixed == 42);
  CHECK(warnings_of(outcome->report, ErrorCode::odd_boundary) == 1);
}

TEST_CASE("every region of odd count has a triangle of its own") {
  // Four edges on the common side; the other sides make one count odd, or both.
  const auto outline = [](double x, int across) {
    Loop loop;
    for (int k = 0; k < 4; ++k) loop.push_back({x + 1, 0.25 * k});
    for (int k = 0; k < across; ++k) loop.push_back({x + 1 - 1.0 * k / across, 1});
    for (int k = 0; k < 4; ++k) loop.push_back({x, 1 - 0.25 * k});
    for (int k = 0; k < 4; ++k) loop.push_back({x + 0.25 * k, 0});
    return loop;
  };
  for (const auto& [left, right] : {std::array{5, 4}, std::array{5, 3}, std::array{4, 4}}) {
    DomainInput input;
    input.regions.push_back({"", {outline(0, left)}, {}});
    input.regions.push_back({"", {outline(1, right)}, {}});
    const auto outcome = mesh_domain(input, one_triangle);
    REQUIRE(outcome);
    CHECK(check_output(outcome->mesh).empty());
    std::array<Index, 2> found{};
    for (std::size_t f = 0; f < outcome->mesh.faces.size(); ++f)
      if (corner_count(outcome->mesh.faces[f]) == 3) ++found[outcome->mesh.region[f]];
    CHECK(found == std::array<Index, 2>{left % 2, right % 2});
  }
}

TEST_CASE("the error about an odd count names both ways out") {
  const auto refused = mesh_domain(with_midpoint(square(1, 0.1), 2), {.keep_boundary = true});
  REQUIRE(!refused.has_value());
  CHECK(refused.error().code == ErrorCode::odd_boundary);
  CHECK(refused.error().message.find("one-triangle") != std::string::npos);
  CHECK(refused.error().message.find("allowAddedPoint") != std::string::npos);
}

TEST_CASE("a region cut in two by a polyline is meshed on both sides, whatever the counts") {
  DomainInput input = domain_of({sampled_polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 0.125)});
  for (const int pieces : {7, 8}) {  // with 7 both sides are odd
    input.polylines = {{{}, "cut"}};
    for (int k = 0; k <= pieces; ++k)
      input.polylines[0].points.push_back({0.875 + 0.25 * k / pieces, 1.0 * k / pieces});
    const auto kept = mesh_domain(input, {.keep_boundary = true});
    CHECK(kept.has_value() == (pieces == 8));
    if (!kept) {
      const Where& where = kept.error().where;
      CHECK(kept.error().code == ErrorCode::odd_boundary);
      CHECK((where.has_point && where.x > 0 && where.x < 2 && where.y >= 0 && where.y <= 1));
      CHECK(where.x * 16 == std::floor(where.x * 16));  // the middle of an edge
    }

    const auto mixed = mesh_domain(input, one_triangle);
    REQUIRE(mixed);
    CHECK(check_output(mixed->mesh).empty());
    std::array<Index, 2> found{};
    for (const Face& face : triangles_of(mixed->mesh)) {
      const Vec2 centre = centre_of(mixed->mesh.points, face);
      ++found[centre.x > 0.875 + 0.25 * centre.y ? 1 : 0];
    }
    CHECK(found == (pieces == 7 ? std::array<Index, 2>{1, 1} : std::array<Index, 2>{0, 0}));

    for (const double size : {0.125, 0.1, 0.083, 0.07}) {
      const auto refined = mesh_domain(input, {.size = size});
      REQUIRE(refined);
      CHECK(check_output(refined->mesh).empty());
      CHECK(refined->report.quality.triangles == 0);
      CHECK(refined->report.attempts == 1);
      CHECK(refined->report.quality.eta_mean > 0.9);
    }
  }
}

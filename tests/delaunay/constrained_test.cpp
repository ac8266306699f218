// Constrained triangulations: walls, regions, carving, and what is refused.
#include "catch.h"
#include "delaunay/delaunay.h"
#include "mesh/validate.h"
#include "support/delaunay_checks.h"

using namespace lpq_test;
using lpq::ErrorCode;
using lpq::triangulate;

namespace {

lpq::TriMesh check_mesh(const BoundaryMesh& boundary, const std::vector<Vec2>& interior = {}) {
  auto mesh = triangulate(boundary, interior);
  if (!mesh.has_value()) INFO(mesh.error().message);
  REQUIRE(mesh.has_value());
  CHECK(mesh->fixed == static_cast<Index>(boundary.points.size()));
  CHECK(mesh->vertex_count() == mesh->fixed + static_cast<Index>(interior.size()));
  CHECK(lpq::validate(*mesh).empty());
  CHECK(occupied_edges(*mesh) == 0);
  CHECK(walls_of(*mesh) == expected_walls(boundary));
  const double area = boundary_area(boundary);
  CHECK(mesh_area(*mesh) == lpq_test::Approx(area).epsilon(1e-12));
  return *std::move(mesh);
}

// A comb: thin teeth, so that most boundary edges are not Delaunay.
BoundaryMesh comb(int teeth) {
  Loop loop;
  for (int i = 0; i < teeth; ++i) {
    loop.push_back({i + 0.0, 0.0});
    loop.push_back({i + 0.5, 100.0 + (i * 37 % 11)});
  }
  loop.push_back({double(teeth), 0.0});
  loop.push_back({0.5 * teeth, -1.0});
  return boundary_of({loop});
}

}  // namespace

TEST_CASE("simple domains are carved and walled") {
  check_mesh(boundary_of({rectangle({0, 0}, {1, 1})}));
  check_mesh(boundary_of({{{0, 0}, {1, 0}, {0, 1}}}));
  check_mesh(flower_with_holes());
  check_mesh(flower_with_holes(), points_inside(flower_with_holes(), 2000, 1, 0.01));
}

TEST_CASE("edges that are far from Delaunay are forced") {
  check_mesh(comb(3));
  check_mesh(comb(200));
  check_mesh(comb(2000));
  check_mesh(spiral(1000));
  check_mesh(spiral(1000), points_inside(spiral(1000), 300, 2, 0.004));
}

TEST_CASE("one segment through thousands of points") {
  BoundaryMesh boundary = boundary_of({rectangle({-1, -1}, {2, 2})});
  add_polyline(boundary, {{-0.5, 0.5003}, {1.5, 0.4998}});
  const auto mesh = check_mesh(boundary, random_points(5000, 3));
  CHECK(mesh.region == std::vector<Index>(mesh.triangles.size(), 0));
}

TEST_CASE("constraints inside: fans, dangling polylines, isolated points") {
  for (int seed = 0; seed < 50; ++seed) {
    BoundaryMesh boundary = boundary_of({rectangle({-1, -1}, {2, 2})});
    lpq::Rng rng(seed);
    // A star of polylines from a common centre, each with a bend: their ends dangle.
    const Index centre = static_cast<Index>(boundary.points.size());
    boundary.points.push_back({0.5, 0.5});
    for (int ray = 0; ray < 9; ++ray) {
      const double a = (ray + 0.8 * rng.unit()) * 2 * 3.14159265358979323846 / 9;
      const Vec2 direction{std::cos(a), std::sin(a)};
      const Index bend = static_cast<Index>(boundary.points.size());
      boundary.points.push_back(Vec2{0.5, 0.5} + (0.2 + 0.3 * rng.unit()) * direction);
      boundary.points.push_back(boundary.points.back() + 0.6 * rng.unit() * direction +
                                0.01 * perpendicular(direction));
      add_segment(boundary, centre, bend, 0, 0);
      add_segment(boundary, bend, bend + 1, 0, 0);
    }
    boundary.points.push_back({-0.9, -0.8});  // isolated
    check_mesh(boundary, random_points(seed * 4, seed + 1000));
  }
}

TEST_CASE("random disjoint segments in random points agree with a full certificate") {
  for (int seed = 0; seed < 100; ++seed) {
    BoundaryMesh boundary = boundary_of({rectangle({-1, -1}, {2, 2})});
    lpq::Rng rng(seed + 77);
    std::vector<std::array<Vec2, 2>> segments;
    for (int trial = 0; trial < 60; ++trial) {
      const Vec2 p{rng.unit(), rng.unit()}, q{rng.unit(), rng.unit()};
      const bool crosses = std::any_of(segments.begin(), segments.end(), [&](const auto& s) {
        return lpq::orient2d(p, q, s[0]) * lpq::orient2d(p, q, s[1]) <= 0 &&
               lpq::orient2d(s[0], s[1], p) * lpq::orient2d(s[0], s[1], q) <= 0;
      });
      if (crosses) continue;
      segments.push_back({p, q});
      add_polyline(boundary, {p, q});
    }
    check_mesh(boundary, random_points(80, seed + 5000));
  }
}

TEST_CASE("integer grids with constraints along and across the grid") {
  BoundaryMesh boundary = boundary_of({rectangle({-1, -1}, {21, 21})});
  add_polyline(boundary, {{0, 1}, {20, 2}});
  add_polyline(boundary, {{0, 5}, {19, 6}, {20, 18}});
  add_polyline(boundary, {{3, 7}, {10, 20}});
  std::vector<Vec2> interior;
  for (int x = 0; x <= 20; ++x) {
    for (int y = 0; y <= 20; ++y) {
      const Vec2 p{double(x), double(y)};
      bool on_wall = false;
      for (const lpq::Segment& s : boundary.edges) {
        const Vec2 a = boundary.points[s.a], b = boundary.points[s.b];
        on_wall = on_wall || (lpq::orient2d(a, b, p) == 0 && dot(p - a, p - b) <= 0);
      }
      if (!on_wall) interior.push_back(p);
    }
  }
  const auto mesh = check_mesh(boundary, interior);
  CHECK(integer_twice_area(mesh) == 2 * 22 * 22);
}

TEST_CASE("regions are labelled from the segments' sides") {
  // Two squares side by side, a third nested in the second, a hole in the first.
  BoundaryMesh boundary;
  boundary.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  for (const auto& [a, b, region] :
       {std::array{0, 1, 0}, {1, 2, 1}, {2, 3, 1}, {3, 4, 1}, {4, 5, 0}, {5, 0, 0}}) {
    add_segment(boundary, a, b, region, none);
  }
  add_segment(boundary, 1, 4, 0, 1);
  add_loop(boundary, rectangle({1.25, 0.25}, {1.75, 0.75}), 2, 1);
  Loop hole = rectangle({0.25, 0.25}, {0.75, 0.75});
  std::reverse(hole.begin(), hole.end());
  add_loop(boundary, hole, 0, none);
  std::vector<Vec2> interior;
  for (const Vec2 p : random_points(1000, 4)) {
    const Vec2 q{2 * p.x, p.y};
    const bool in_hole = q.x < 0.76 && q.x > 0.24 && q.y < 0.76 && q.y > 0.24;
    if (!in_hole) interior.push_back(q);
  }
  const auto mesh = triangulate(boundary, interior);
  REQUIRE(mesh.has_value());
  CHECK(lpq::validate(*mesh).empty());
  CHECK(walls_of(*mesh) == expected_walls(boundary));
  std::array<double, 3> area{};
  for (Index t = 0; t < mesh->triangle_count(); ++t) {
    const auto& [a, b, c] = mesh->triangles[t];
    area[mesh->region[t]] +=
        0.5 * cross(mesh->points[b] - mesh->points[a], mesh->points[c] - mesh->points[a]);
  }
  CHECK(area[0] == lpq_test::Approx(0.75));
  CHECK(area[1] == lpq_test::Approx(0.75));
  CHECK(area[2] == lpq_test::Approx(0.25));
}

TEST_CASE("what lies outside, on a wall, twice, or across is an error, never a hang") {
  const BoundaryMesh square =
      boundary_of({rectangle({0, 0}, {1, 1}), rectangle({0.4, 0.4}, {0.6, 0.6})});
  const auto code = [&](const std::vector<Vec2>& interior) {
    const auto result = triangulate(square, interior);
    REQUIRE(!result.has_value());
    CHECK(result.error().where.has_point);
    return result.error().code;
  };
  CHECK(code({{0.2, 0.2}, {1.5, 0.5}}) == ErrorCode::hole_outside);
  CHECK(code({{0.2, 0.2}, {0.5, 0.5}}) == ErrorCode::hole_outside);
  CHECK(code({{0.2, 0.0}}) == ErrorCode::hole_outside);
  CHECK(code({{0.5, 0.4}}) == ErrorCode::hole_outside);
  CHECK(code({{1.0, 1.0}}) == ErrorCode::duplicate_point);
  CHECK(code({{0.3, 0.3}, {0.3, 0.3}}) == ErrorCode::duplicate_point);
  const auto message = triangulate(square, std::vector<Vec2>{{0.2, 0.2}, {1.5, 0.5}});
  CHECK(message.error().message.find("point 1 ") != std::string::npos);
  CHECK(message.error().where.x == 1.5);

  BoundaryMesh touching = square;
  add_polyline(touching, {{0.1, 0.2}, {0.3, 0.2}});
  add_polyline(touching, {{0.2, 0.2}, {0.2, 0.1}});
  CHECK(triangulate(touching, {}).error().code == ErrorCode::touching);
  BoundaryMesh crossing = square;
  add_polyline(crossing, {{0.1, 0.2}, {0.3, 0.2}});
  add_polyline(crossing, {{0.2, 0.25}, {0.2, 0.1}});
  const auto crossed = triangulate(crossing, {});
  REQUIRE(!crossed.has_value());
  CHECK(crossed.error().code == ErrorCode::self_intersection);
  CHECK(crossed.error().where.x == lpq_test::Approx(0.2));
  CHECK(crossed.error().where.y == lpq_test::Approx(0.2));
}

TEST_CASE("nearly collinear boundaries") {
  lpq::Rng rng(6);
  Loop strip;
  for (int i = 0; i < 4000; ++i) strip.push_back({i / 4000.0, 1e-15 * rng.unit()});
  for (int i = 0; i < 4000; ++i) strip.push_back({1 - i / 4000.0, 0.01 + 1e-15 * rng.unit()});
  check_mesh(boundary_of({strip}));
}

TEST_CASE("a comb of 100000 nodes", "[slow]") {
  // Inner and outer nodes alternate: the hardest input for segment insertion,
  // since nearly every boundary edge is missing and crosses many others' triangles.
  const int n = 100000;
  Loop loop;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * 3.14159265358979323846 * i / n;
    const double radius = i % 2 == 1 ? 1 : 0.5 + 0.3 * std::sin(7 * a);
    loop.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  check_mesh(boundary_of({loop}));
}

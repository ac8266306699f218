// Plain Delaunay triangulations against the definition, and their independence of order and unit.
#include <numeric>

#include "catch.h"
#include "delaunay/delaunay.h"
#include "mesh/validate.h"
#include "support/delaunay_checks.h"

using namespace lpq_test;
using lpq::ErrorCode;
using lpq::triangulate;

namespace {

// Everything that a Delaunay triangulation of distinct points must be. Euler: T = 2 V - 2 - H with
// H hull edges, which needs every vertex used and the hull convex.
void check_delaunay(const std::vector<Vec2>& points) {
  const auto mesh = triangulate(points);
  REQUIRE(mesh.has_value());
  CHECK(lpq::validate(*mesh).empty());
  CHECK(occupied_edges(*mesh) == 0);
  if (points.size() <= 500) CHECK(occupied_circles(*mesh) == 0);
  const auto hull = walls_of(*mesh);
  CHECK(mesh->triangle_count() == 2 * mesh->vertex_count() - 2 - static_cast<int>(hull.size()));
  if (points.size() <= 500) {
    int beyond = 0;
    for (const auto& [a, b] : hull) {
      for (const Vec2 p : points) beyond += lpq::orient2d(points[a], points[b], p) < 0;
    }
    CHECK(beyond == 0);
  }
}

}  // namespace

TEST_CASE("random points have empty circles") {
  for (int n = 3; n <= 40; ++n) {
    for (int seed = 0; seed < 10; ++seed) check_delaunay(random_points(n, 1000 * n + seed));
  }
  check_delaunay(random_points(500, 1));
  check_delaunay(random_points(20000, 2));
}

TEST_CASE("grids, cocircular and nearly degenerate points have empty circles") {
  for (int seed = 0; seed < 200; ++seed) {
    const int side = 2 + seed % 7;
    const auto points = random_grid_points(3 + seed % 30, side, seed);
    bool flat = true;
    for (const Vec2 p : points) flat = flat && lpq::orient2d(points[0], points[1], p) == 0;
    if (!flat) check_delaunay(points);
  }
  check_delaunay(random_grid_points(10000, 100, 7));
  check_delaunay(cocircular_points());
  std::vector<Vec2> scaled = cocircular_points();
  for (Vec2& p : scaled) p = 0.1 * p;
  check_delaunay(scaled);
  scaled.push_back({0, 0});
  check_delaunay(scaled);
}

TEST_CASE("points on lines: collinear hulls, one apex, nearly collinear") {
  lpq::Rng rng(3);
  std::vector<Vec2> line;
  for (int i = 0; i < 400; ++i) line.push_back({rng.unit(), 0});
  for (const Vec2 apex : {Vec2{0.3, 1e-9}, Vec2{0.3, -1.0}, Vec2{5, 1}}) {
    auto points = line;
    points.push_back(apex);
    check_delaunay(points);
  }
  for (Vec2& p : line) p.y = 0.3 * p.x + 0.1;  // collinear up to rounding
  check_delaunay(line);
}

TEST_CASE("clusters of very different scales") {
  lpq::Rng rng(4);
  std::vector<Vec2> points;
  for (int level = 0; level < 8; ++level) {
    const double scale = std::pow(0.01, level);
    for (int i = 0; i < 60; ++i) points.push_back({scale * rng.unit(), scale * rng.unit()});
  }
  check_delaunay(points);
}

TEST_CASE("the order of the points does not matter in general position") {
  for (int seed = 0; seed < 20; ++seed) {
    const auto points = random_points(200, seed);
    std::vector<Index> number(points.size());
    std::iota(number.begin(), number.end(), 0);
    lpq::Rng rng(seed + 100);
    for (std::size_t i = number.size(); i > 1; --i) {
      std::swap(number[i - 1], number[rng.below(i)]);
    }
    std::vector<Vec2> shuffled(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) shuffled[number[i]] = points[i];
    const auto a = triangulate(points), b = triangulate(shuffled);
    REQUIRE((a.has_value() && b.has_value()));
    CHECK(same_triangulation(renumbered(*a, number), *b));
  }
}

TEST_CASE("scaling by a power of two changes nothing, ties included") {
  auto points = random_grid_points(300, 25, 5);
  const auto original = triangulate(points);
  for (Vec2& p : points) p = 0x1p-30 * p;
  const auto scaled = triangulate(points);
  REQUIRE((original.has_value() && scaled.has_value()));
  CHECK(original->triangles == scaled->triangles);
  CHECK(original->twins == scaled->twins);
}

TEST_CASE("the area of a triangulated grid is exact") {
  const auto mesh = triangulate(random_grid_points(64 * 64, 64, 6));
  REQUIRE(mesh.has_value());
  CHECK(integer_twice_area(*mesh) == 2 * 63 * 63);
}

TEST_CASE("bad point sets are named") {
  CHECK(triangulate(std::vector<Vec2>{{0, 0}, {1, 0}}).error().code == ErrorCode::too_few_points);
  std::vector<Vec2> line;
  for (int i = 0; i < 50; ++i) line.push_back({double(i), 2.0 * i});
  CHECK(triangulate(line).error().code == ErrorCode::zero_area);
  auto points = random_points(100, 8);
  points.push_back(points[37]);
  const auto result = triangulate(points);
  REQUIRE(!result.has_value());
  CHECK(result.error().code == ErrorCode::duplicate_point);
  CHECK(result.error().where.x == points[37].x);
  CHECK(result.error().message.find("37 and 100") != std::string::npos);
  CHECK(triangulate(std::vector<Vec2>{{1, 1}, {1, 1}, {1, 1}}).error().code ==
        ErrorCode::duplicate_point);
}

TEST_CASE("the Hilbert order is a permutation of short steps") {
  const auto points = random_points(10000, 9);
  const auto order = lpq::hilbert_order(points);
  std::vector<char> seen(points.size(), 0);
  double path = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    seen[order[k]] = 1;
    if (k > 0) path += distance(points[order[k - 1]], points[order[k]]);
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == 10000);
  CHECK(path < 2 * std::sqrt(10000.0));  // a space-filling path has length about sqrt(n)
}

TEST_CASE("a million points", "[slow]") {
  const auto mesh = triangulate(random_points(1000000, 10));
  REQUIRE(mesh.has_value());
  CHECK(lpq::validate(*mesh).empty());
  CHECK(occupied_edges(*mesh) == 0);
}

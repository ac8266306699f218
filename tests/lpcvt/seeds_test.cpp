// Seeds: inside, clear of walls and each other, as many as fit, the same bits every time.
#include "lpcvt/seeds.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "delaunay/delaunay.h"
#include "field/inside.h"
#include "field/make_fields.h"
#include "geometry/grid.h"
#include "mesh/quality.h"
#include "support/field_shapes.h"
#include "support/packed_seeds.h"

using namespace lpq;
using namespace lpq::test;

namespace {

Fields fields_of(const BoundaryMesh& boundary, const FieldOptions& options = {}) {
  auto result = make_fields(boundary, options);
  REQUIRE(result.has_value());
  return std::move(*result);
}

double distance_to_walls(const BoundaryMesh& boundary, Vec2 p) {
  double best2 = 1e300;
  for (const Segment& s : boundary.edges) {
    const Vec2 a = boundary.points[s.a], d = boundary.points[s.b] - a;
    const double t = std::clamp(dot(p - a, d) / squared_length(d), 0.0, 1.0);
    best2 = std::min(best2, squared_length(p - (a + t * d)));
  }
  return std::sqrt(best2);
}

void check_seeds(const BoundaryMesh& boundary, const Fields& fields, const std::vector<Vec2>& seeds,
                 double clearance, double separation) {
  const auto region = regions_of(boundary, seeds);
  Index hint = none;
  double closest_wall = 1e300, closest_pair = 1e300;
  bool all_inside = true;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    all_inside &= region[i] != none;
    const double h = fields.size(seeds[i], hint);
    closest_wall = std::min(closest_wall, distance_to_walls(boundary, seeds[i]) / h);
    for (std::size_t j = 0; j < i; ++j)
      closest_pair = std::min(closest_pair, distance(seeds[i], seeds[j]) / h);
  }
  CHECK(all_inside);
  CHECK(closest_wall >= clearance);
  CHECK(closest_pair >= separation);
  CHECK(triangulate(boundary, seeds).has_value());
}

double tau_of(const BoundaryMesh& boundary, const std::vector<Vec2>& seeds) {
  const auto mesh = triangulate(boundary, seeds);
  REQUIRE(mesh.has_value());
  return tau(*mesh);
}

std::vector<BoundaryMesh> shapes() {
  return {square_boundary(0.05),     disc_boundary(80), annulus_boundary(80, 60),
          plate_with_hole(0.05, 24), l_shape(0.05),     graded_saw(7)};
}

}  // namespace

TEST_CASE("expected interior points follow Euler") {
  const auto count = [](const BoundaryMesh& b) {
    return expected_interior_points(b, fields_of(b));
  };
  CHECK(count(square_boundary(0.1)) == lpq_test::Approx(81).epsilon(1e-9));
  CHECK(count(l_shape(0.1)) == lpq_test::Approx(75 - 20 + 1).epsilon(1e-9));
  const auto ring = boundary_of({divided(rectangle({0, 0}, {1, 1}), 0.1),
                                 reversed(divided(rectangle({0.3, 0.3}, {0.6, 0.6}), 0.1))});
  CHECK(count(ring) == lpq_test::Approx(91 - 26).epsilon(1e-9));
}

TEST_CASE("every kind of seed is inside and clear") {
  for (const BoundaryMesh& boundary : shapes()) {
    const Fields fields = fields_of(boundary);
    check_seeds(boundary, fields, isotropic_seeds(boundary, fields), 0.399, 0.5);
    check_seeds(boundary, fields, packed_seeds(boundary, fields, {}), 0.499, 0.55);
    check_seeds(boundary, fields, aligned_seeds(boundary, fields), 0.399, 0.5);
  }
}

TEST_CASE("given seeds are kept bit for bit, except those that cannot be seeds") {
  const BoundaryMesh boundary = plate_with_hole(0.05, 24);
  const Fields fields = fields_of(boundary);
  const std::vector<Vec2> good = isotropic_seeds(boundary, fields);
  std::vector<Vec2> points = good;
  points.push_back(good.front());                                      // twice
  points.push_back(boundary.points.front());                           // on a node
  points.push_back(midpoint(boundary.points[0], boundary.points[1]));  // on a wall
  points.push_back({1e6, 0});                                          // far outside
  CHECK(given_seeds(boundary, fields, points) == good);
  CHECK(given_seeds(boundary, fields, {}).empty());
}

TEST_CASE("counts fit what is expected") {
  for (const BoundaryMesh& boundary : shapes()) {
    const Fields fields = fields_of(boundary);
    const double expected = expected_interior_points(boundary, fields);
    const auto count = [](const std::vector<Vec2>& points) {
      return static_cast<double>(points.size());
    };
    CHECK(std::abs(count(isotropic_seeds(boundary, fields)) - expected) <= 0.01 * expected + 1);
    CHECK(std::abs(count(aligned_seeds(boundary, fields)) - expected) <= 0.1 * expected + 6);
    CHECK(std::abs(count(packed_seeds(boundary, fields, {})) - expected) <= 0.2 * expected + 8);
  }
}

TEST_CASE("aligned seeds of a divided square are its grid") {
  for (const double angle : {0.0, 0.35}) {
    const Vec2 turn{std::cos(angle), std::sin(angle)};
    const auto boundary = boundary_of({turned_by(divided(rectangle({0, 0}, {1, 1}), 0.05), turn)});
    const auto seeds = aligned_seeds(boundary, fields_of(boundary));
    REQUIRE(seeds.size() == 19 * 19);
    for (const Vec2 p : seeds) {
      const Vec2 q = 20 * complex_product(p, conjugate(turn));
      CHECK(std::abs(q.x - std::floor(q.x + 0.5)) < 1e-6);
      CHECK(std::abs(q.y - std::floor(q.y + 0.5)) < 1e-6);
    }
  }
}

TEST_CASE("seeds of a stretched plane are the grid of squares that it stands for") {
  // x counts sqrt 2 times and y as much less: squares are twice as high as wide.
  std::vector<Vec2> loop = divided(rectangle({0, 0}, {2, 1}), 0.1);
  for (Vec2& p : loop) p.x *= 0.5;
  BoundaryMesh boundary = boundary_of({loop});
  boundary.spacing.assign(loop.size(), 0.1 * std::sqrt(0.5));
  FieldOptions options;
  options.stretch_function = [](Vec2) { return Vec2{1.0 / 3, 0}; };
  const Fields fields = fields_of(boundary, options);
  for (const auto& seeds : {aligned_seeds(boundary, fields), packed_seeds(boundary, fields, {})}) {
    REQUIRE(seeds.size() == 19 * 9);
    for (const Vec2 p : seeds) {
      CHECK(std::abs(20 * p.x - std::floor(20 * p.x + 0.5)) < 1e-6);
      CHECK(std::abs(10 * p.y - std::floor(10 * p.y + 0.5)) < 1e-6);
    }
  }
  const double count = static_cast<double>(isotropic_seeds(boundary, fields).size());
  CHECK(std::abs(count - 19 * 9) <= 2);
}

TEST_CASE("aligned seeds make right-angled triangles") {
  const auto boundary = plate_with_hole(0.025, 46);
  const Fields fields = fields_of(boundary);
  CHECK(tau_of(boundary, aligned_seeds(boundary, fields)) > 0.985);
  CHECK(tau_of(boundary, packed_seeds(boundary, fields, {})) > 0.98);
  CHECK(tau_of(boundary, isotropic_seeds(boundary, fields)) < 0.95);
}

TEST_CASE("packing keeps the points it is given") {
  const auto boundary = square_boundary(0.1);
  const Fields fields = fields_of(boundary);
  const std::vector<Vec2> given{{0.33, 0.41}, {0.7, 0.72}};
  const auto seeds = packed_seeds(boundary, fields, given);
  REQUIRE(seeds.size() > 60);
  CHECK(seeds[0] == given[0]);
  CHECK(seeds[1] == given[1]);
}

TEST_CASE("seeds respect the limit on points") {
  const auto boundary = square_boundary(0.05);
  const Fields fields = fields_of(boundary);
  SeedOptions options;
  options.max_points = 50;
  CHECK(packed_seeds(boundary, fields, {}, options).size() == 50);
  CHECK(aligned_seeds(boundary, fields, options).size() == 50);
  CHECK(isotropic_seeds(boundary, fields, options).size() == 50);
}

TEST_CASE("seeds are deterministic and scale with the domain bit for bit") {
  const auto all_seeds = [](const BoundaryMesh& boundary) {
    const Fields fields = fields_of(boundary);
    auto points = isotropic_seeds(boundary, fields);
    for (const auto& more : {packed_seeds(boundary, fields, {}), aligned_seeds(boundary, fields)})
      points.insert(points.end(), more.begin(), more.end());
    return points;
  };
  const auto boundary = plate_with_hole(0.05, 24);
  const auto once = all_seeds(boundary);
  CHECK(once == all_seeds(boundary));
  const double scale = 0x1p-17;
  const auto small = all_seeds(scaled(boundary, scale));
  REQUIRE(small.size() == once.size());
  bool same = true;
  for (std::size_t i = 0; i < once.size(); ++i) same &= small[i] == scale * once[i];
  CHECK(same);
}

TEST_CASE("the point grid finds what a full search finds") {
  PointGrid grid;
  std::vector<Vec2> points;
  std::vector<double> sizes;
  Rng rng(11);
  for (Index i = 0; i < 2000; ++i) {
    points.push_back({rng.between(-1, 1), rng.between(-1, 1)});
    sizes.push_back(0.02 * (1.2 + points.back().x));
    grid.insert(points.back(), sizes.back(), i);
  }
  for (int i = 0; i < 500; ++i) {
    const Vec2 p{rng.between(-1, 1), rng.between(-1, 1)};
    const double h = 0.02 * (1.2 + p.x), radius = 0.8 * h;
    int found = 0, expected = 0;
    grid.any_near(p, h, radius, [&](Index, Vec2) { return ++found, false; });
    for (const Vec2 q : points)
      expected += std::abs(q.x - p.x) <= radius && std::abs(q.y - p.y) <= radius;
    CHECK(found == expected);
  }
}

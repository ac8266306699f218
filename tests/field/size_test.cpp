// The size field: what the walls or the caller ask for, never too steep, and errors for nonsense.
#include <cmath>
#include <limits>

#include "catch.h"
#include "field/make_fields.h"
#include "support/field_shapes.h"

using namespace lpq;
using namespace lpq::test;

namespace {

void check_slopes(const Fields& fields, double growth) {
  const TriMesh& mesh = fields.background;
  double worst = 0;
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Index i = mesh.origin(e), j = mesh.target(e);
    const double room = fields.h[i] + growth * distance(mesh.points[i], mesh.points[j]);
    worst = std::max(worst, fields.h[j] / room);
  }
  CHECK(worst <= 1 + 1e-12);
}

void check_walls(const Fields& fields, const BoundaryMesh& boundary) {
  for (std::size_t v = 0; v < boundary.points.size(); ++v) {
    CHECK(fields.h[v] > 0);
    CHECK(fields.h[v] <= boundary.spacing[v] * (1 + 1e-12));
  }
}

Fields fields_of(const BoundaryMesh& boundary, const FieldOptions& options = {}) {
  auto result = make_fields(boundary, options);
  REQUIRE(result.has_value());
  return std::move(*result);
}

}  // namespace

TEST_CASE("even spacing gives the same size everywhere") {
  const auto boundary = disc_boundary(100);
  for (const double h : fields_of(boundary).h) CHECK(std::abs(h / boundary.spacing[0] - 1) < 1e-9);
}

TEST_CASE("slopes stay below the growth asked for") {
  for (const double growth : {0.1, 0.3, 1.0}) {
    FieldOptions options;
    options.growth = growth;
    for (const auto& boundary :
         {graded_saw(10), annulus_boundary(40, 200), plate_with_hole(0.1, 60)}) {
      const Fields fields = fields_of(boundary, options);
      check_slopes(fields, growth);
      check_walls(fields, boundary);
    }
  }
}

TEST_CASE("a constant size fills the inside and yields to shorter walls") {
  FieldOptions options;
  options.size = 0.05;
  const auto boundary = annulus_boundary(20, 120);
  const Fields fields = fields_of(boundary, options);
  check_slopes(fields, options.growth);
  check_walls(fields, boundary);
  double largest = 0;
  for (const double h : fields.h) largest = std::max(largest, h);
  CHECK(largest == 0.05);
}

TEST_CASE("sizes at points and size functions are met") {
  const auto boundary = square_boundary(0.1);
  FieldOptions at_points;
  at_points.sizes = {{{0.5, 0.5}, 0.01}};
  const Fields points = fields_of(boundary, at_points);
  check_slopes(points, at_points.growth);
  Index hint = none;
  CHECK(points.size({0.5, 0.5}, hint) <= 0.01 * (1 + 1e-12));
  CHECK(points.size({0.5, 0.5}, hint) > 0.0075);
  CHECK(points.size({0.1, 0.1}, hint) > 0.05);

  FieldOptions by_function;
  by_function.size_function = [](Vec2 p) { return 0.02 + 0.1 * p.x; };
  const Fields function = fields_of(boundary, by_function);
  check_slopes(function, by_function.growth);
  for (double x = 0.15; x < 0.8; x += 0.05)
    CHECK(function.size({x, 0.4}, hint) == lpq_test::Approx(0.02 + 0.1 * x).epsilon(0.02));
}

TEST_CASE("a size at a point holds around it before it may grow fast") {
  const auto boundary = square_boundary(0.1);
  FieldOptions options;
  options.size = 0.1;
  options.sizes = {{{0.47, 0.52}, 0.01}};
  for (const double growth : {0.3, 1.0, 10.0}) {
    options.growth = growth;
    const Fields fields = fields_of(boundary, options);
    check_slopes(fields, growth);
    CHECK(fields.has_spots);
    Index hint = none;
    for (const Vec2 d : {Vec2{1, 0}, {0, 1}, {-0.6, 0.8}, {0.8, -0.6}})
      CHECK(fields.size(Vec2{0.47, 0.52} + 0.03 * d, hint) < 0.016);
    CHECK(fields.size({0.85, 0.85}, hint) == lpq_test::Approx(0.1));
  }
  options.growth = 0.08;
  CHECK_FALSE(fields_of(boundary, options).has_spots);
}

TEST_CASE("a size at a point outside grows on its way in") {
  const auto boundary = square_boundary(0.1);
  FieldOptions options;
  options.size = 0.1;
  options.growth = 0.08;
  Index hint = none;
  for (const Vec2 away : {Vec2{3, 3}, Vec2{-40, 0.5}}) {
    options.sizes = {{away, 0.001}};
    CHECK(fields_of(boundary, options).size({0.9, 0.9}, hint) == lpq_test::Approx(0.1));
  }
  options.sizes = {{{1.5, 0.5}, 0.001}};  // 0.04 more at the nearest side
  const double inside = fields_of(boundary, options).size({0.98, 0.5}, hint);
  CHECK(inside > 0.03);
  CHECK(inside < 0.06);
}

TEST_CASE("sizes that are no sizes are refused") {
  const auto boundary = square_boundary(0.1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [&](const FieldOptions& options) {
    const auto result = make_fields(boundary, options);
    return !result.has_value() && result.error().code == ErrorCode::bad_size;
  };
  for (const double bad : {-1.0, nan, infinity}) {
    FieldOptions size, growth, point, function, coarseness;
    size.size = growth.growth = coarseness.coarseness = bad;
    point.sizes = {{{0.5, 0.5}, bad}};
    function.size_function = [bad](Vec2 p) { return p.x > 0.5 ? bad : 0.1; };
    CHECK(refused(size));
    CHECK(refused(growth));
    CHECK(refused(coarseness));
    CHECK(refused(point));
    CHECK(refused(function));
  }
  FieldOptions zero;
  zero.size_function = [](Vec2) { return 0.0; };
  CHECK(refused(zero));
}

TEST_CASE("an isolated node takes its size from around it") {
  BoundaryMesh boundary = square_boundary(0.1);
  boundary.points.push_back({0.43, 0.56});
  boundary.world.push_back({0.43, 0.56});
  boundary.spacing.push_back(0);
  boundary.source.push_back(none);
  boundary.output_rank.push_back(static_cast<Index>(boundary.points.size()) - 1);
  const Fields fields = fields_of(boundary);
  CHECK(fields.h[boundary.points.size() - 1] == lpq_test::Approx(0.1).epsilon(1e-6));
}

TEST_CASE("cell capacity counts unit cells") {
  CHECK(cell_capacity(fields_of(square_boundary(0.05))) == lpq_test::Approx(400).epsilon(1e-9));
  FieldOptions options;
  options.size_function = [](Vec2 p) { return 0.04 + 0.1 * p.x; };
  options.coarseness = 1;
  const double exact = (1 / 0.04 - 1 / 0.14) / 0.1;  // integral of dx / (a + b x)^2
  const auto boundary = boundary_of({rectangle({0, 0}, {1, 1})});
  CHECK(cell_capacity(fields_of(boundary, options)) == lpq_test::Approx(exact).epsilon(0.01));
}

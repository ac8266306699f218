// The cross field: exact where the walls agree, singular where topology says so.
#include <cmath>

#include "catch.h"
#include "field/make_fields.h"
#include "support/field_shapes.h"

using namespace lpq;
using namespace lpq::test;

namespace {

int total_index(const Fields& fields) {
  int sum = 0;
  for (const Singularity& s : fields.singularities) sum += s.index;
  return sum;
}

Fields fields_of(const BoundaryMesh& boundary) {
  auto result = make_fields(boundary);
  REQUIRE(result.has_value());
  return std::move(*result);
}

}  // namespace

TEST_CASE("cross_of and axis_of are inverse up to quarter turns") {
  for (int i = 0; i < 720; ++i) {
    const double a = i * 3.14159265358979323846 / 360;
    const Vec2 d{std::cos(a), std::sin(a)};
    const Vec2 axis = axis_of(cross_of(1e-200 * d));
    CHECK(std::abs(length(axis) - 1) < 1e-14);
    CHECK(axis.x > 0.7071);
    CHECK(std::min(std::abs(dot(axis, d)), std::abs(cross(axis, d))) < 1e-14);
  }
  CHECK(axis_of({0, 0}) == Vec2{1, 0});
}

TEST_CASE("a turned square has the same cross everywhere") {
  const double a = 0.3;
  const Vec2 turn{std::cos(a), std::sin(a)};
  const auto boundary = boundary_of({turned_by(divided(rectangle({0, 0}, {1, 1}), 0.05), turn)});
  const Fields fields = fields_of(boundary);
  const Vec2 expected = cross_of(turn);
  for (const Vec2 z : fields.z) CHECK(length(z - expected) < 1e-10);
  CHECK(fields.singularities.empty());
}

TEST_CASE("singularities add up to what corners and holes leave over") {
  // Sum of indices = 4 chi - sum over corners of (2 - quads at the corner).
  const Fields disc = fields_of(disc_boundary(120));
  CHECK(total_index(disc) == 4);
  CHECK(disc.singularities.size() == 4);
  const Fields ring = fields_of(annulus_boundary(120, 50));
  CHECK(ring.singularities.empty());
  CHECK(fields_of(l_shape(0.05)).singularities.empty());
  CHECK(total_index(fields_of(plate_with_hole(0.04, 30))) == -4);
  CHECK(total_index(fields_of(boundary_of({divided(regular_polygon(3, 0.5), 0.04)}))) == 1);
  CHECK(total_index(fields_of(boundary_of({divided(regular_polygon(5, 0.5), 0.04)}))) == -1);
  CHECK(total_index(fields_of(boundary_of({divided(regular_polygon(6, 0.5), 0.04)}))) == -2);
}

TEST_CASE("wall vertices follow their walls, corners of 45 degrees stay finite") {
  const auto boundary = boundary_of({divided({{0, 0}, {1, 0}, {0, 1}}, 0.05)});
  const Fields fields = fields_of(boundary);
  for (const Vec2 z : fields.z) CHECK(std::abs(length(z) - 1) < 1e-12);
  const Vec2 slanted = cross_of({-1, 1});
  for (Index v = 0; v < fields.background.fixed; ++v) {
    const Vec2 p = fields.background.points[v];
    const bool corner = p == Vec2{0, 0} || p == Vec2{1, 0} || p == Vec2{0, 1};
    if (corner) continue;
    CHECK(length(fields.z[v] - (p.x + p.y > 0.99 ? slanted : Vec2{1, 0})) < 1e-9);
  }
}

TEST_CASE("a constraint inside the domain directs the crosses") {
  BoundaryMesh boundary = square_boundary(0.1);
  const Index first = static_cast<Index>(boundary.points.size());
  for (int i = 0; i <= 4; ++i) {
    boundary.points.push_back({0.4 + 0.05 * i, 0.35 + 0.075 * i});
    boundary.spacing.push_back(0.09);
    boundary.source.push_back(none);
    boundary.output_rank.push_back(first + i);
    if (i > 0) boundary.edges.push_back({first + i - 1, first + i, 0, 0, none, none, none, none});
  }
  boundary.world = boundary.points;
  const Fields fields = fields_of(boundary);
  const Vec2 expected = cross_of({0.05, 0.075});
  for (Index v = first; v < first + 5; ++v) CHECK(length(fields.z[v] - expected) < 1e-9);
}

TEST_CASE("turning the domain by 90 degrees turns nothing") {
  // Crosses are invariant under quarter turns; the background is not, so agreement is approximate.
  const auto boundary = plate_with_hole(0.04, 30);
  BoundaryMesh turned = boundary;
  for (Vec2& p : turned.points) p = {-p.y, p.x};
  const Fields a = fields_of(boundary), b = fields_of(turned);
  Index hint_a = none, hint_b = none;
  double worst = 0;
  for (int i = 1; i < 20; ++i)
    for (int j = 1; j < 16; ++j) {
      const Vec2 p{0.05 * i, 0.05 * j};
      const double r = distance(p, {0.45, 0.4});
      bool singular = r < 0.2;
      for (const Singularity& s : a.singularities) singular |= distance(s.position, p) < 0.12;
      if (singular) continue;
      const FieldSample fa = a.sample(p, hint_a), fb = b.sample({-p.y, p.x}, hint_b);
      worst = std::max(
          worst, std::min(std::abs(dot(fa.axis, fb.axis)), std::abs(cross(fa.axis, fb.axis))));
      CHECK(std::abs(fa.h - fb.h) < 0.02 * fa.h);
    }
  CHECK(worst < 0.05);
}

TEST_CASE("the caller's angle replaces the solve") {
  FieldOptions options;
  options.angle_function = [](Vec2 p) { return 0.4 + 0.1 * p.x; };
  const auto fields = make_fields(square_boundary(0.1), options);
  REQUIRE(fields.has_value());
  Index hint = none;
  const FieldSample s = fields->sample({0.52, 0.47}, hint);
  CHECK(std::abs(s.axis.x - std::cos(0.452)) < 1e-3);
  CHECK(std::abs(s.grad_theta.x - 0.1) < 1e-3);
}

TEST_CASE("an angle that is no number, or beyond all turns, is refused with its place") {
  for (const double wrong : {std::nan(""), 1e300, -1e5}) {
    FieldOptions options;
    options.angle_function = [wrong](Vec2 p) { return p.x > 0.5 ? wrong : 0.0; };
    const auto fields = make_fields(square_boundary(0.1), options);
    REQUIRE(!fields.has_value());
    CHECK(fields.error().code == ErrorCode::non_finite);
    CHECK(fields.error().where.x > 0.5);
  }
}

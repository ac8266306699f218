// Guides: the crosses follow the strokes, on a background fine enough for it, and nothing else
// changes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rng.h"
#include "catch.h"
#include "field/make_fields.h"
#include "support/field_shapes.h"

using namespace lpq;
using namespace lpq::test;

namespace {

using Guide = DomainInput::Guide;

Guide arc(Vec2 centre, double radius, double from, double to, int pieces) {
  Guide guide;
  for (int i = 0; i <= pieces; ++i) {
    const double a = from + (to - from) * i / pieces;
    guide.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return guide;
}

Fields guided(const BoundaryMesh& boundary, double size, std::vector<Guide> guides) {
  FieldOptions options;
  options.size = size;
  options.guides = std::move(guides);
  auto fields = make_fields(boundary, options);
  REQUIRE(fields.has_value());
  return std::move(*fields);
}

// Degrees, up to quarter turns.
double angle_between(Vec2 axis, Vec2 direction) {
  const double a = std::abs(std::atan2(cross(axis, direction), dot(axis, direction)));
  const double quarter = std::fmod(a * 180 / 3.14159265358979323846, 90);
  return std::min(quarter, 90 - quarter);
}

// The largest error of the crosses at the middles of the guide's pieces.
double worst_angle(const Fields& fields, const Guide& guide) {
  double worst = 0;
  Index hint = none;
  for (std::size_t i = 1; i < guide.size(); ++i)
    worst =
        std::max(worst, angle_between(fields.sample(midpoint(guide[i - 1], guide[i]), hint).axis,
                                      guide[i] - guide[i - 1]));
  return worst;
}

void check_same(const Fields& a, const Fields& b) {
  CHECK(a.background.points == b.background.points);
  CHECK(a.background.triangles == b.background.triangles);
  CHECK(a.z == b.z);
  CHECK(a.h == b.h);
}

}  // namespace

TEST_CASE("crosses follow guides, curves as closely as these turn over one mesh size") {
  const double size = 0.04;
  const auto turn = [&](double radius) { return size / radius * 180 / 3.14159265358979323846; };
  const Guide diagonal{{0.3, 0.3}, {0.45, 0.45}, {0.6, 0.6}};
  for (const auto& boundary : {square_boundary(size), disc_boundary(80)}) {
    CHECK(worst_angle(guided(boundary, size, {diagonal}), diagonal) < 0.5);
    const Guide bow = arc({0.5, 0.1}, 0.45, 0.9, 2.2, 40);
    CHECK(worst_angle(guided(boundary, size, {bow}), bow) < turn(0.45));
    const Guide ring = arc({0.5, 0.5}, 0.3, 0, 6.28318530717958648, 60);
    CHECK(worst_angle(guided(boundary, size, {ring}), ring) < turn(0.3));
  }
}

TEST_CASE("the background is as fine along guides as the target asks, and only there") {
  const double size = 0.01;
  const Guide slanted{{0.35, 0.4}, {0.65, 0.62}};
  const Fields plain = guided(square_boundary(size), size, {});
  const Fields fields = guided(square_boundary(size), size, {slanted});
  CHECK(fields.background.triangle_count() < 1.3 * plain.background.triangle_count());
  Index hint = none;
  for (int i = 0; i <= 100; ++i) {
    const Vec2 p = slanted[0] + 0.01 * i * (slanted[1] - slanted[0]);
    const auto [a, b, c] = fields.background.triangles[fields.locator.find_nearest(p, hint)];
    const auto& at = fields.background.points;
    CHECK(std::max({distance(at[a], at[b]), distance(at[b], at[c]), distance(at[c], at[a])}) <
          4 * size);
  }
}

TEST_CASE("a shaking hand draws the stroke it means") {
  const double size = 0.04;
  Rng rng(3);
  Guide shaken;
  for (int i = 0; i <= 400; ++i)
    shaken.push_back({0.3 + 0.001 * i + rng.between(-0.1, 0.1) * size,
                      0.35 + 0.0007 * i + rng.between(-0.1, 0.1) * size});
  const Fields fields = guided(square_boundary(size), size, {shaken});
  CHECK(worst_angle(fields, {{0.31, 0.357}, {0.5, 0.49}, {0.69, 0.623}}) < 8);
}

TEST_CASE("guides outside the domain are without effect") {
  const auto boundary = plate_with_hole(0.04, 30);
  const Fields plain = guided(boundary, 0.04, {});
  const Guide beside{{-0.5, 0.2}, {-0.1, 0.6}}, in_hole{{0.4, 0.35}, {0.5, 0.45}};
  const Guide far{{1e90, 1e90}, {2e90, -3e90}, {1e120, 5}};
  for (const Guide& guide : {beside, in_hole, far}) {
    const Fields fields = guided(boundary, 0.04, {guide});
    check_same(fields, plain);
  }
  // What comes in from outside counts inside.
  const Guide across{{-0.4, -0.1}, {1.4, 1.1}};
  const Fields fields = guided(boundary, 0.04, {across});
  CHECK(worst_angle(fields, {{0.7, 0.7 * 2 / 3 + 0.1666666666666667}, {0.8, 0.7}}) < 1);
}

TEST_CASE("guides that contradict each other do no harm") {
  const Guide one{{0.3, 0.5}, {0.7, 0.5}};
  const Guide other{{0.3, 0.5}, {0.5, 0.7}, {0.3, 0.5}, {0.3, 0.5}, {0.7, 0.9}};
  const Fields fields = guided(square_boundary(0.04), 0.04, {one, other, one});
  for (const Vec2 z : fields.z) CHECK((length(z) < 1e-12 || std::abs(length(z) - 1) < 1e-12));
}

TEST_CASE("a given angle wins over guides") {
  FieldOptions options;
  options.size = 0.04;
  options.angle_function = [](Vec2) { return 0.0; };
  options.guides = {{{0.3, 0.3}, {0.7, 0.7}}};
  const auto fields = make_fields(square_boundary(0.04), options);
  REQUIRE(fields.has_value());
  CHECK(fields->pull.empty());
  for (const Vec2 z : fields->z) CHECK(z == Vec2{1, 0});
}

TEST_CASE("guides that are none are refused, with their number") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Guide good{{0.3, 0.3}, {0.7, 0.7}};
  const auto refused = [&](const Guide& bad) {
    FieldOptions options;
    options.guides = {good, bad};
    const auto fields = make_fields(square_boundary(0.1), options);
    REQUIRE(!fields.has_value());
    CHECK(fields.error().where.guide == 1);
    CHECK(fields.error().message.find("guide 1") != std::string::npos);
    return fields.error();
  };
  CHECK(refused({}).code == ErrorCode::bad_option);
  CHECK(refused({{0.5, 0.5}}).code == ErrorCode::bad_option);
  const Error still = refused({{0.5, 0.25}, {0.5, 0.25}, {0.5, 0.25}});
  CHECK(still.code == ErrorCode::bad_option);
  CHECK(still.where.x == 0.5);
  CHECK(still.where.y == 0.25);
  for (const double bad : {std::nan(""), infinity, -infinity, 1e200}) {
    const Error error = refused({{0.5, 0.5}, {0.6, bad}});
    CHECK(error.code == ErrorCode::non_finite);
    CHECK(error.where.edge == 1);
  }
}

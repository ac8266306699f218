// DXF: curves against closed forms, assembly, what is refused.
#include "io/domain/dxf_domain.h"

#include "catch.h"
#include "io/domain/bspline.h"
#include "numerics/elementary.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainFile read_dxf(const std::string& entities) {
  return lpq_test::read_file(dxf(entities), DomainFormat::dxf);
}
double area(const std::string& entities) { return total_area(read_dxf(entities).domain); }

/// Below the true area, and by no more than 2e-4 of the size all along the outline.
void check_area(const std::string& entities, double exact, double size, double perimeter) {
  const double found = area(entities);
  INFO(entities << ": " << found << ", exactly " << exact);
  CHECK(std::abs(found - exact) < 2e-4 * size * perimeter);
}

const std::string open_square =
    "0 LINE 10 0 20 0 11 4 21 0 0 LINE 10 4 20 0 11 4 21 4 "
    "0 LINE 10 4 20 4 11 0 21 4 ";

}  // namespace

TEST_CASE("DXF curves have the areas of their formulas") {
  check_area("0 CIRCLE 10 5 20 6 40 2", 4 * pi, 4, 4 * pi);
  check_area("0 ELLIPSE 10 1 20 1 11 0 21 3 40 0.5", 4.5 * pi, 6, 15);
  // Half discs and a quarter of an ellipse, closed by lines.
  check_area("0 ARC 10 0 20 0 40 1 50 0 51 180 0 LINE 10 -1 20 0 11 1 21 0", pi / 2, 2, pi);
  check_area("0 ARC 10 0 20 0 40 1 50 270 51 90 0 LINE 10 0 20 -1 11 0 21 1", pi / 2, 2, pi);
  check_area("0 ARC 10 0 20 0 40 1 50 0 51 180 210 0 220 0 230 -1 0 LINE 10 -1 20 0 11 1 21 0",
             pi / 2, 2, pi);
  check_area(
      "0 ELLIPSE 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966 "
      "0 LINE 10 2 20 0 11 0 21 0 0 LINE 10 0 20 0 11 0 21 1",
      pi / 2, 2, 3);
  // Seen from below, the minor axis points the other way.
  check_area(
      "0 ELLIPSE 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966 230 -1 "
      "0 LINE 10 2 20 0 11 0 21 0 0 LINE 10 0 20 0 11 0 21 -1",
      pi / 2, 2, 3);
}

TEST_CASE("bulges are tangents of quarter angles, to the left") {
  check_area("0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 2 20 0 42 1", pi, 2, 2 * pi);
  // A quarter turn bulging out of, then into, a square of side 2.
  const double segment = pi / 2 - 1, quarter = 0.41421356237309503;
  const auto square = [](double bulge) {
    return std::string("0 LWPOLYLINE 70 1 10 0 20 0 42 ") + std::to_string(bulge) +
           " 10 2 20 0 10 2 20 2 10 0 20 2";
  };
  check_area(square(quarter), 4 + segment, 2.5, 3);
  check_area(square(-quarter), 4 - segment, 2.5, 3);
  // The old polyline, closed by its flag, with a spline frame point that is not on it.
  check_area(
      "0 POLYLINE 70 1 0 VERTEX 10 0 20 0 42 1 0 VERTEX 70 16 10 9 20 9 "
      "0 VERTEX 10 2 20 0 42 1 0 SEQEND",
      pi, 2, 2 * pi);
  // A hair of a bulge is a line, not a circle as wide as the solar system.
  CHECK(area("0 LWPOLYLINE 70 1 10 0 20 0 42 1e-14 10 2 20 0 10 2 20 2 10 0 20 2") == 4);
  const auto mirrored = read_dxf("0 LWPOLYLINE 70 1 230 -1 10 0 20 0 10 2 20 0 10 2 20 1");
  for (const Vec2 p : mirrored.domain.regions[0].loops[0]) CHECK(p.x <= 0);
}

TEST_CASE("splines: de Boor's algorithm on curves that are known") {
  // The full circle as a rational quadratic of nine points.
  const double h = 0.70710678118654757;
  const BSpline circle{
      2,
      {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
      {1, h, 1, h, 1, h, 1, h, 1}};
  REQUIRE(spline_problem(circle) == nullptr);
  for (int i = 0; i <= 64; ++i) CHECK(std::abs(length(spline_point(circle, i / 16.0)) - 1) < 1e-15);
  std::vector<Vec2> polygon;
  flatten(circle, 1e-4, polygon);
  CHECK(polygon.front() == Vec2{1, 0});
  CHECK(polygon.back() == Vec2{1, 0});
  CHECK(std::abs(signed_area(polygon) - pi) < 2 * pi * 1e-4);
  // A Bezier curve is the spline without inner knots.
  const BSpline bezier{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {}};
  CHECK(spline_point(bezier, 0.5) == Vec2{0.5, 0.75});
  CHECK(spline_point(bezier, 0) == Vec2{0, 0});
  CHECK(spline_point(bezier, 1) == Vec2{1, 0});
  // Uniform knots: the cubic basis functions are 1/6, 4/6, 1/6 at a knot.
  const BSpline uniform{
      3, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {{6, 0}, {0, 6}, {6, 12}, {0, 0}, {0, 6}}, {}};
  CHECK(distance(spline_point(uniform, 3), {2, 6}) < 1e-14);
  CHECK(distance(spline_point(uniform, 4), {4, 9}) < 1e-14);

  check_area(
      "0 SPLINE 70 0 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 "
      "10 0 20 0 10 0 20 1 10 1 20 1 10 1 20 0 0 LINE 10 1 20 0 11 0 21 0",
      0.6, 1, 2);
}

TEST_CASE("a natural spline reproduces lines and meets its end conditions") {
  const std::vector<Vec2> line{{0, 0}, {1, 2}, {3, 6}, {4, 8}};
  const double unit = std::sqrt(5.0);
  for (const Vec2 t : natural_spline_tangents(line, {unit, 2 * unit, unit}))
    CHECK(distance(t, {1 / unit, 2 / unit}) < 1e-14);
  const std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 0}, {3, 3}};
  const auto t = natural_spline_tangents(points, {1, 1, 1});
  const auto second = [&](std::size_t i, double u) {  // derivative on piece i
    const Vec2 d = points[i + 1] - points[i];
    return (6 - 12 * u) * d + (6 * u - 4) * t[i] + (6 * u - 2) * t[i + 1];
  };
  CHECK(length(second(0, 0)) < 1e-13);
  CHECK(length(second(2, 1)) < 1e-13);
  CHECK(distance(second(0, 1), second(1, 0)) < 1e-13);
  CHECK(distance(second(1, 1), second(2, 0)) < 1e-13);
  const auto file =
      read_dxf("0 SPLINE 71 3 11 0 21 0 11 1 21 1 11 2 21 0 0 LINE 10 2 20 0 11 0 21 0");
  CHECK(file.warnings.size() == 1);
  CHECK(file.domain.regions.size() == 1);
}

TEST_CASE("entities are joined into loops whatever their order and direction") {
  CHECK(area(open_square + "0 LINE 10 0 20 0 11 0 21 4") == 16);
  // A gap within 1e-5 of the size is closed with a warning, within rounding without one.
  const auto gap = read_dxf(open_square + "0 LINE 10 0 20 0.00003 11 0 21 4");
  REQUIRE(gap.warnings.size() == 1);
  CHECK(gap.warnings[0].where.has_point);
  CHECK(read_dxf(open_square + "0 LINE 10 0 20 1e-12 11 0 21 4").warnings.empty());
  const Error open = refusal(dxf(open_square + "0 LINE 10 0 20 0.1 11 0 21 4"), DomainFormat::dxf);
  CHECK(open.code == ErrorCode::parse_error);
  REQUIRE(open.where.has_point);
  CHECK(open.where.x == 0);
  CHECK((open.where.y == 0 || open.where.y == 0.1));
  CHECK(open.where.line > 0);
  CHECK(open.message.find("0.1") != std::string::npos);
}

TEST_CASE("a line from wall to wall divides the plate, and an open end tells what is near") {
  const std::string plate = open_square + "0 LINE 10 0 20 0 11 0 21 4 ";
  const auto two = read_dxf(plate + "0 LINE 8 rib 10 1 20 0 11 1 21 4");
  REQUIRE(two.domain.regions.size() == 2);
  CHECK(two.warnings.empty());
  CHECK(total_area(two.domain) == 16);
  CHECK(make_domain(two.domain).has_value());
  CHECK(read_dxf(plate + "0 LINE 10 1 20 0.00003 11 1 21 4").warnings.size() == 1);
  const Error open = refusal(dxf(plate + "0 LINE 10 1 20 0 11 1 21 3.5"), DomainFormat::dxf);
  CHECK(open.where.y == 3.5);
  CHECK(open.message.find("the nearest line is 0.5 away") != std::string::npos);
  const Error along =
      refusal(dxf(open_square + "0 LINE 10 0 20 4 11 0 21 1 0 LINE 10 0 20 2 11 0 21 0"),
              DomainFormat::dxf);
  CHECK(along.message.find("lies on a line that runs along its own") != std::string::npos);
  const Error bridge =
      refusal(dxf(plate + "0 CIRCLE 10 2 20 2 40 1 0 LINE 10 0 20 2 11 1 21 2"), DomainFormat::dxf);
  CHECK(bridge.message.find("leads from outline to outline") != std::string::npos);
}

TEST_CASE("lines that end on the curve itself divide what it encloses") {
  const auto line = [](Vec2 a, Vec2 b) {
    return "0 LINE 10 " + std::to_string(a.x) + " 20 " + std::to_string(a.y) + " 11 " +
           std::to_string(b.x) + " 21 " + std::to_string(b.y);
  };
  const auto check_halves = [](const std::string& entities, double exact) {
    INFO(entities);
    const auto file = read_dxf(entities);
    CHECK(file.domain.regions.size() == 2);
    CHECK(file.warnings.empty());
    CHECK(std::abs(total_area(file.domain) - exact) < 0.005 * exact);
    CHECK(make_domain(file.domain).has_value());
  };
  const std::string circle = "0 CIRCLE 10 0 20 0 40 5 ";
  check_halves(circle + line({3, 4}, {3, -4}), 25 * pi);
  check_halves(circle + line({-4, 3}, {4, 3}), 25 * pi);
  for (int i = 0; i < 40; ++i) {
    const SinCos from = sin_cos(0.1 + 0.07 * i), to = sin_cos(2.3 + 0.11 * i);
    check_halves(circle + line({5 * from.cos, 5 * from.sin}, {5 * to.cos, 5 * to.sin}), 25 * pi);
    check_halves("0 ELLIPSE 10 0 20 0 11 5 21 0 40 0.4 " +
                     line({5 * from.cos, 2 * from.sin}, {5 * to.cos, 2 * to.sin}),
                 10 * pi);
  }
  // An arc that ends on the circle, and a cubic: B(1/4) is (10, 36) / 64.
  check_halves(circle + "0 ARC 10 5 20 0 40 5 50 120 51 240", 25 * pi);
  check_halves(
      "0 SPLINE 70 0 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 0 20 1 10 1 20 1 "
      "10 1 20 0 0 LINE 10 1 20 0 11 0 21 0 0 LINE 10 0.15625 20 0.5625 11 0.15625 21 0",
      0.6);
  // What ends beside the curve is open.
  CHECK(refusal(dxf(circle + "0 LINE 10 -4.99 20 0 11 4.99 21 0"), DomainFormat::dxf)
            .message.find("is open at") != std::string::npos);
}

TEST_CASE("two dividing lines that cross are told of as that") {
  const Error error = refusal(dxf(open_square + "0 LINE 10 0 20 4 11 0 21 0 "
                                                "0 LINE 10 1 20 0 11 1 21 4 "
                                                "0 LINE 10 0 20 3 11 4 21 3"),
                              DomainFormat::dxf);
  CHECK(error.message.find("Two lines cross near (1, 3)") != std::string::npos);
  CHECK(error.where.x == 1);
  CHECK(error.where.y == 3);
  CHECK(error.where.line > 0);
}

TEST_CASE("layers become tags and names; lines that divide make neighbours") {
  const auto file = read_dxf(
      "0 LWPOLYLINE 8 steel 70 1 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4 "
      "0 CIRCLE 8 bolt 10 2 20 3 40 0.5 0 LINE 8 0 10 0 20 0 11 4 21 0 "
      "0 LWPOLYLINE 8 0 70 0 10 0 20 0 10 2 20 1 10 4 20 0");
  REQUIRE(file.domain.regions.size() == 2);
  REQUIRE(file.warnings.size() == 1);  // an edge drawn twice
  const double triangle = 4;
  const bool first = file.domain.regions[0].loops.size() == 1;
  CHECK(region_area(file.domain.regions[first ? 0 : 1]) == triangle / 2);
  const auto& plate = file.domain.regions[first ? 1 : 0];
  REQUIRE(plate.tags.size() == 2);
  CHECK(std::count(plate.tags[0].begin(), plate.tags[0].end(), "steel") == 3);
  CHECK(plate.tags[1].front() == "bolt");
  CHECK(make_domain(file.domain).has_value());
  CHECK(read_dxf("0 CIRCLE 8 bolt 10 2 20 3 40 0.5").domain.regions[0].name == "bolt");
}

TEST_CASE("what DXF leaves out is counted") {
  const auto file = read_dxf(
      "0 CIRCLE 10 0 20 0 30 5 40 1 0 INSERT 2 x 10 0 20 0 66 1 0 ATTRIB 1 y 0 SEQEND "
      "0 TEXT 1 z 0 TEXT 1 z 0 CIRCLE 67 1 10 0 20 0 40 9");
  REQUIRE(file.warnings.size() == 3);
  CHECK(file.warnings[0].message == "Curves in paper space were left out: 1.");
  CHECK(file.warnings[1].message == "Left out: 1 INSERT without its block and 2 TEXT.");
  CHECK(file.warnings[2].message.find("z other than 0") != std::string::npos);
  CHECK(file.domain.regions[0].loops.size() == 1);
  const auto paper = read_dxf("0 CIRCLE 67 1 10 0 20 0 40 9");
  CHECK(paper.warnings.size() == 1);
}

TEST_CASE("DXF that cannot be read is refused with its line") {
  for (const char* entities :
       {"0 CIRCLE 10 0 20 0 40 -1", "0 CIRCLE 10 0 20 0", "0 CIRCLE 10 x 20 0 40 1",
        "0 CIRCLE 10 nan 20 0 40 1", "0 CIRCLE 10 0 20 1e999 40 1",
        "0 ARC 10 0 20 0 40 1 50 0 51 1e300", "0 CIRCLE 10 0 20 0 40 1 210 1 230 1",
        "0 ELLIPSE 10 0 20 0 11 0 21 0 40 1", "0 SPLINE 71 3 40 0 10 0 20 0",
        "0 SPLINE 71 99 40 0 10 0 20 0",
        "0 SPLINE 71 1 40 0 40 0 40 1 40 1 10 0 20 0 10 1 20 1 41 1 41 -1",
        "0 SPLINE 71 1 40 1 40 0 40 1 40 1 10 0 20 0 10 1 20 1", "x"}) {
    INFO(entities);
    const Error error = refusal(dxf(entities), DomainFormat::dxf);
    CHECK(error.code == ErrorCode::parse_error);
    CHECK(error.where.line > 0);
    CHECK(error.where.byte >= 0);
  }
  CHECK(refusal(dxf(""), DomainFormat::dxf).code == ErrorCode::empty);
  CHECK(refusal(dxf("0 POINT 10 0 20 0"), DomainFormat::dxf).message.find("1 POINT") !=
        std::string::npos);
  CHECK(refusal("AutoCAD Binary DXF\r\n\x1a", DomainFormat::dxf).message.find("ASCII") !=
        std::string::npos);
  CHECK(refusal("0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n", DomainFormat::dxf).code ==
        ErrorCode::parse_error);
}

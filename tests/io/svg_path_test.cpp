// Path data of SVG against known points and closed forms.
#include "io/domain/svg_path.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "catch.h"
#include "numerics/elementary.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// The flattened subpaths, fine enough to compare points.
std::vector<std::vector<Vec2>> points_of(const std::string& data) {
  std::vector<Subpath> subpaths;
  const MaybeProblem problem = read_path_data(data, subpaths);
  INFO(data << (problem ? problem->message : ""));
  REQUIRE_FALSE(problem);
  std::vector<std::vector<Vec2>> result;
  for (const Subpath& subpath : subpaths) {
    result.emplace_back();
    subpath.curve.flatten(1e-6, result.back());
    if (subpath.closed) result.back().push_back(result.back().front());
  }
  return result;
}

void check_points(const std::string& data, const std::vector<std::vector<Vec2>>& expected) {
  INFO(data);
  CHECK(points_of(data) == expected);
}

/// The largest distance of the path's points from the circle.
double off_circle(const std::string& data, Vec2 centre, double radius) {
  double worst = 0;
  for (const auto& subpath : points_of(data))
    for (const Vec2 p : subpath) worst = std::max(worst, std::abs(distance(p, centre) - radius));
  return worst;
}

}  // namespace

TEST_CASE("path data: lines in all their spellings") {
  const std::vector<std::vector<Vec2>> square{{{1, 2}, {3, 2}, {3, 4}, {1, 4}, {1, 2}}};
  for (const char* data :
       {"M1 2L3 2L3 4L1 4Z", "M1,2 3,2 3,4 1,4z", "m1 2 2 0 0 2-2 0z", "M 1 2 H 3 V 4 H 1 Z",
        "m1 2h2v2h-2z", "M1 2l2 0,0 2-2 0z", "  M+1e0,20e-1h2.v.2e1h-2.0z\n", "M1 2L3 2 3 4 1 4z"})
    check_points(data, square);
  check_points("M0 0h1v1zm2 2h1v1z",
               {{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {{2, 2}, {3, 2}, {3, 3}, {2, 2}}});
  check_points("M1 1h1v1zh-1v-1z",
               {{{1, 1}, {2, 1}, {2, 2}, {1, 1}}, {{1, 1}, {0, 1}, {0, 0}, {1, 1}}});
  check_points("M.5.5.75-.5", {{{0.5, 0.5}, {0.75, -0.5}}});
  check_points("M5 5M1 1H2", {{{1, 1}, {2, 1}}});
  CHECK(points_of("").empty());
  CHECK(points_of("M1 1").empty());
}

TEST_CASE("path data: curves pass through the points of their formulas") {
  const auto has = [](const std::string& data, Vec2 wanted) {
    double best = 1;
    for (const auto& subpath : points_of(data))
      for (const Vec2 p : subpath) best = std::min(best, distance(p, wanted));
    INFO(data << " through " << wanted.x << " " << wanted.y);
    CHECK(best < 1e-14);
  };
  // Halving a curve gives its value at 1/2 and 1/4 exactly.
  for (const char* data : {"M0 0C0 1 1 1 1 0", "m0 0c0 1 1 1 1 0"}) {
    has(data, {0.5, 0.75});
    has(data, {10.0 / 64, 36.0 / 64});
  }
  for (const char* data : {"M0 0Q1 2 2 0", "M0 0q1 2 2 0"}) has(data, {1, 1});
  // S and T mirror the last control point, of a curve of their own kind only.
  has("M0 0C0 1 1 1 1 0S2-1 2 0", {1.5, -0.75});
  has("M0 0c0 1 1 1 1 0s1-1 1 0", {1.5, -0.75});
  has("M0 0Q1 2 2 0T4 0", {3, -1});
  has("M0 0q1 2 2 0t2 0", {3, -1});
  has("M0 0Q1 2 2 0T4 0T6 0", {5, 1});
  has("M0 0L2 0S4 2 4 0", {2.0 / 8 * 4 + 12.0 / 8 + 4.0 / 8, 6.0 / 8});
  const auto turned = points_of("M0 0C0 1 1 1 1 0T3 0")[0];  // a T without a Q before it is a line
  CHECK(turned[turned.size() - 2] == Vec2{1, 0});
}

TEST_CASE("path data: arcs lie on their ellipses") {
  for (const char* data :
       {"M1 0A1 1 0 0 1 0 1", "M1 0a1 1 0 0 1-1 1", "M1 0A1 1 0 01 0 1", "M1 0a1 1 0 01-1 1",
        "M1 0A1 1 0 1 1 0-1", "M1 0A1 1 0 0 0 0-1", "M1,0A1,1,0,0,1,-1,0", "M1 0A-1-1 90 0 1-1 0"})
    CHECK(off_circle(data, {0, 0}, 1) < 1e-14);
  // Large and small arcs, both ways round: where the arc from (1, 0) to (0, 1) goes.
  const auto middle = [](const std::string& flags) {
    const auto points = points_of("M1 0A1 1 0 " + flags + " 0 1")[0];
    return points[points.size() / 2];
  };
  CHECK(middle("0 1").x > 0.5);
  CHECK(middle("1 0").x < -0.5);
  CHECK(middle("0 0").x < 0.5);
  CHECK(middle("1 1").x > 1.5);
  CHECK(off_circle("M1 0A1 1 0 1 1 0 1", {1, 1}, 1) < 1e-14);
  // Radii that are too small grow; no radius is a line; no distance is nothing.
  CHECK(off_circle("M0 0A.1 .1 0 0 1 2 0", {1, 0}, 1) < 1e-14);
  check_points("M0 0A0 1 0 0 1 2 0", {{{0, 0}, {2, 0}}});
  CHECK(points_of("M0 0A1 1 0 0 1 0 0").empty());
  // An ellipse twice as long as wide, turned by 90 degrees.
  const auto ellipse = points_of("M1 0A2 1 90 0 1-1 0");
  for (const Vec2 p : ellipse[0]) CHECK(std::abs(p.x * p.x + p.y * p.y / 4 - 1) < 1e-14);
}

TEST_CASE("path data that is wrong is refused at its character") {
  const std::pair<const char*, std::size_t> wrong[] = {{"L1 1", 0},
                                                       {"M1", 2},
                                                       {"M1 1 2", 6},
                                                       {"M1 1X", 4},
                                                       {"M1 1L1 x", 7},
                                                       {"M1 1 & 2", 5},
                                                       {"M0 0A1 1 0 2 0 1 1", 11},
                                                       {"M0 0h", 5},
                                                       {"M0 0C1 1 2 2 3", 14},
                                                       {"M0 0 1e999 0", 5},
                                                       {"M1 1z5", 5},
                                                       {"M0 0 NaN 1", 5}};
  for (const auto& [data, at] : wrong) {
    std::vector<Subpath> subpaths;
    const MaybeProblem problem = read_path_data(data, subpaths);
    INFO(data);
    REQUIRE(problem);
    CHECK(problem->at == at);
  }
  const Error error = refusal(svg("<g>\n<path\n d='M0 0 L1 x'/></g>"), DomainFormat::svg);
  CHECK(error.where.line == 5);
  CHECK(svg("<g>\n<path\n d='M0 0 L1 x'/></g>")[static_cast<std::size_t>(error.where.byte)] == 'x');
}

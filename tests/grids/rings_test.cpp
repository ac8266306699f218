// Grids round a hole: the plane about a point as a strip, lines along it, and the rings of quads.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "catch.h"
#include "grids/lattice.h"
#include "grids/loop_turns.h"
#include "grids/polar.h"
#include "grids/submapped_grid.h"
#include "numerics/elementary.h"
#include "pipeline/mesher.h"
#include "support/check_grid.h"
#include "support/meshed_surface.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// To the left.
Loop circle(Vec2 centre, double radius, int edges, double turned = 0) {
  Loop loop;
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * pi * (k + turned) / edges;
    loop.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return loop;
}

/// With teeth as long as an edge is.
Loop gear(double radius, int teeth) {
  const double edge = 2 * pi * radius / (6 * teeth);
  Loop loop;
  for (int k = 0; k < 6 * teeth; ++k) {
    const double angle = 2 * pi * k / (6 * teeth);
    const auto point = [&](double r) {
      loop.push_back({r * std::cos(angle), r * std::sin(angle)});
    };
    const int in_tooth = k % 6;
    if (in_tooth <= 3) point(radius + edge * (in_tooth == 0 ? 0 : 1));
    if (in_tooth == 0) point(radius + edge);
    if (in_tooth == 3) point(radius);
    if (in_tooth > 3) point(radius);
  }
  return loop;
}

/// The chain at its end, its boundary as given.
Mesher finished(const std::vector<Loop>& loops) {
  DomainInput input;
  input.regions.emplace_back().loops = loops;
  auto mesher = Mesher::start(input, {.keep_boundary = true});
  REQUIRE(mesher);
  while (mesher->stage() != Stage::done) REQUIRE(mesher->step());
  return *std::move(mesher);
}

std::optional<QuadMesh> grid_of(const Mesher& mesher, double wanted) {
  return ring_grid(mesher.boundary(), mesher.triangles(), wanted);
}

/// Two circles, joined in the plane z = 0 and behind it.
SurfaceSoup washer_soup(double outer, double inner, int edges) {
  SurfaceSoup soup;
  for (const double r : {outer, inner})
    for (const double z : {0.0, 1.0})
      for (const Vec2 p : circle({}, r, edges)) soup.points.push_back({p.x, p.y, z});
  const auto quad = [&soup](Index a, Index b, Index c, Index d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for (Index k = 0; k < edges; ++k) {
    const Index next = (k + 1) % edges;
    const auto at = [edges](Index ring, Index i) { return ring * edges + i; };
    quad(at(0, k), at(0, next), at(1, next), at(1, k));  // outside
    quad(at(3, k), at(3, next), at(2, next), at(2, k));  // inside
    quad(at(1, k), at(1, next), at(3, next), at(3, k));  // above
    quad(at(2, k), at(2, next), at(0, next), at(0, k));  // below
  }
  return soup;
}

}  // namespace

TEST_CASE("a line about a centre has no leaps, and counts its rounds", "[grids]") {
  const Vec2 centre{0.3, -0.2};
  const auto check = [centre](const Loop& loop, Index rounds) {
    const LineAbout line = line_about(centre, loop);
    REQUIRE(line.points.size() == loop.size());
    CHECK(line.rounds == rounds);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const double r = std::exp(line.points[k].x), angle = line.points[k].y;
      CHECK(distance(centre + r * Vec2{std::cos(angle), std::sin(angle)}, loop[k]) < 1e-12);
      CHECK(std::fabs(angle - 2 * pi * line.sheets[k]) <= pi);
      const Vec2 next = line.points[(k + 1) % loop.size()];
      const double round = k + 1 == loop.size() ? 2 * pi * rounds : 0;
      CHECK(std::fabs(next.y + round - angle) < pi);
    }
  };
  Loop loop = circle(centre, 2, 12, 0.3);
  check(loop, 1);
  std::reverse(loop.begin(), loop.end());
  check(loop, -1);
  check(circle({-1, -0.2}, 1, 9), 0);  // across the ray where angles leap
  CHECK(line_about(centre, {{1, 1}, centre, {0, 1}}).points.empty());
}

TEST_CASE("a line that goes round ends in its column, as many rows further as are wanted",
          "[grids]") {
  for (int seed = 0; seed < 20; ++seed) {
    INFO(seed);
    std::vector<Vec2> points;
    for (int k = 0; k < 24; ++k) points.push_back({0.15 * std::sin(seed + 1.3 * k * k), 0.25 * k});
    const auto end_of = [&points](std::optional<Index> rows) {
      LatticePlace end;
      for (const Index d : line_turns(points, {0, 6}, rows)) end = end + lattice_step(d);
      return end;
    };
    const LatticePlace free = end_of(std::nullopt);
    CHECK(free.x == 0);
    CHECK(free.y > 0);
    for (const Index rows : {18, 22}) CHECK(end_of(rows) == LatticePlace{0, rows});
    CHECK(end_of(21) == LatticePlace{});  // of the other parity
  }
}

TEST_CASE("straight lines stay straight", "[grids]") {
  std::vector<Vec2> points;
  for (int k = 0; k < 17; ++k) points.push_back({2, 0.3 * k});
  for (const Index d : line_turns(points, {0, 17 * 0.3}, std::nullopt)) CHECK((d & 3) == 1);
}

TEST_CASE("the cells of a lattice that goes round", "[grids]") {
  const Index rows = 7;
  LaidLoops laid{{{}, {}}, rows, {}};
  for (Index k = 0; k < rows; ++k) {
    laid.loops[0].nodes.push_back(k);
    laid.loops[0].places.push_back({0, (k + 3) % rows - 20});  // any of the places that are one
    laid.loops[1].nodes.push_back(rows + k);
    laid.loops[1].places.push_back({-4, 2 - k});
  }
  const auto quads = lattice_quads(laid, 2 * rows, 100);
  REQUIRE(quads);
  CHECK(quads->faces.size() == 4 * rows);
  CHECK(quads->inside == 3 * rows);
  std::vector<int> faces_at(static_cast<std::size_t>(2 * rows + quads->inside), 0);
  for (const Face& face : quads->faces)
    for (const Index v : face) ++faces_at[v];
  for (std::size_t v = 0; v < faces_at.size(); ++v) CHECK(faces_at[v] == (v < 2 * rows ? 2 : 4));
  CHECK_FALSE(lattice_quads(laid, 2 * rows, 30));  // too large
  for (LatticePlace& place : laid.loops[1].places) place.x = 4;
  CHECK_FALSE(lattice_quads(laid, 2 * rows, 100));  // inside out
}

TEST_CASE("a ring is a grid", "[grids]") {
  const double ratio = GENERATE(1.2, 1.6, 2.4);
  const Vec2 off = GENERATE(Vec2{0, 0}, Vec2{0.06, 0.03});
  const double turned = GENERATE(0.0, 0.4, 11.7);  // nodes of the two need not be opposite
  const int edges = 36;
  const Mesher mesher = finished({circle({}, ratio, edges), circle(off, 1, edges, turned)});
  const double columns = std::floor(0.5 + edges * std::log(ratio) / (2 * pi));
  const auto grid = grid_of(mesher, edges * columns);
  REQUIRE(grid);
  CHECK(static_cast<double>(grid->faces.size()) == edges * columns);
  check_grid(mesher.boundary(), *grid);
}

TEST_CASE("a ring with holes in it is a grid", "[grids]") {
  const int holes = GENERATE(3, 6);
  std::vector<Loop> loops{circle({}, 2.2, 72), circle({}, 1.1, 72, 0.3)};
  for (const Vec2 at : circle({}, 1.65, holes, 0.49)) loops.push_back(circle(at, 0.19, 8, 0.2));
  const Mesher mesher = finished(loops);
  const auto grid = grid_of(mesher, 72 * 8 - holes * 4);
  REQUIRE(grid);
  const auto quads = static_cast<int>(grid->faces.size());  // an octagon is four cells or three
  CHECK(std::abs(quads - (72 * 8 - holes * 4)) <= holes);
  check_grid(mesher.boundary(), *grid);
  CHECK_FALSE(ring_grid(mesher.boundary(), {}, 72 * 8 - holes * 4));  // nothing tells where
}

TEST_CASE("a wheel with teeth is a grid", "[grids]") {
  const int teeth = 12;
  const Mesher mesher = finished({gear(2, teeth), circle({}, 1.2, 6 * teeth)});
  const double wanted = 6 * teeth * 5 + 3 * teeth;
  const auto grid = grid_of(mesher, wanted);
  REQUIRE(grid);
  CHECK(static_cast<double>(grid->faces.size()) == wanted);
  check_grid(mesher.boundary(), *grid);
}

TEST_CASE("a hole far smaller than the border has no ring", "[grids]") {
  const Mesher mesher = finished({circle({}, 4, 60), circle({}, 1, 16)});
  CHECK_FALSE(grid_of(mesher, 270));
}

TEST_CASE("a washer has no irregular vertex", "[grids]") {
  const double size = GENERATE(0.08, 0.17);
  const double inner = GENERATE(0.55, 0.8);
  const ShellOutcome outcome = meshed(washer_soup(2, 2 * inner, 90), {.size = size});
  CHECK(outcome.report.quality.four_valent_percent == 100);
  CHECK(outcome.report.quality.eta_mean > 0.95);
}

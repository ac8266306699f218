// Grids over faces: how borders run on a lattice, which have a grid, and that it is one.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "catch.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/quad_topology.h"
#include "cleanup/untangle.h"
#include "grids/hole_places.h"
#include "grids/lattice.h"
#include "grids/loop_turns.h"
#include "grids/submapped_grid.h"
#include "mesh/ideal_quads.h"
#include "numerics/elementary.h"
#include "pipeline/mesher.h"
#include "support/check_grid.h"
#include "support/meshed_surface.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// One loop through the points, the domain on its left; every second edge runs against it.
void add_loop(const std::vector<Vec2>& points, BoundaryMesh& boundary) {
  const auto first = static_cast<Index>(boundary.points.size());
  const auto count = static_cast<Index>(points.size());
  boundary.points.insert(boundary.points.end(), points.begin(), points.end());
  for (Index k = 0; k < count; ++k) {
    Segment edge;
    edge.a = first + k;
    edge.b = first + (k + 1) % count;
    edge.left = 0;
    if (k % 2 == 1) {
      std::swap(edge.a, edge.b);
      std::swap(edge.left, edge.right);
    }
    boundary.edges.push_back(edge);
  }
}

/// The sides of a unit square with so many edges each, from its lower left corner, moved by `at`.
template <class At>
std::vector<Vec2> square(std::array<int, 4> edges, At at) {
  constexpr Vec2 corner[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Vec2> points;
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < edges[side]; ++k) {
      const double t = static_cast<double>(k) / edges[side];
      points.push_back(at((1 - t) * corner[side] + t * corner[(side + 1) % 4]));
    }
  return points;
}

const auto same = [](Vec2 p) { return p; };

BoundaryMesh boundary_of(const std::vector<Vec2>& points) {
  BoundaryMesh boundary;
  add_loop(points, boundary);
  return boundary;
}

std::optional<QuadMesh> grid_of(const BoundaryMesh& boundary, double wanted,
                                const TriMesh& triangles = {}) {
  return submapped_grid(boundary, triangles, wanted);
}

/// A polygon that its centre sees whole.
std::vector<Vec2> star(int count, int seed) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * pi * (k + 0.3 * std::sin(seed * 7.1 + k * 3.3)) / count;
    const double r = 1 + 0.4 * std::sin(seed * 1.7 + k * k * 2.9);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

/// Of every edge, quarter turns from the axis to it: those of one that is nearest to the lattice's
/// directions counted from the nearest of them, the others by going round.
std::vector<double> headings_of(const std::vector<Vec2>& points, double axis, Index& nearest,
                                std::size_t& start) {
  const std::size_t n = points.size();
  std::vector<double> heading(n);
  double least = 1;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 edge = points[(k + 1) % n] - points[k];
    const double turned = (std::atan2(edge.y, edge.x) - axis) / (pi / 2);
    if (std::abs(turned - std::round(turned)) >= least) continue;
    least = std::abs(turned - std::round(turned));
    start = k;
    nearest = static_cast<Index>(std::round(turned));
    heading[k] = turned;
  }
  for (std::size_t i = 1; i < n; ++i) {
    const std::size_t k = (start + i) % n, before = (k + n - 1) % n;
    const double angle = sector_angle(points[k], points[(k + 1) % n], points[before]);
    heading[k] = heading[before] + (pi - angle) / (pi / 2);
  }
  return heading;
}

/// Of a way round: for quads at the nodes that do not fit, of one quad with a flat corner much, and
/// for edges off their directions.
double price_of(const std::vector<Vec2>& points, double axis,
                const std::vector<Index>& directions) {
  const std::size_t n = points.size();
  double price = 0;
  Index turns = 0, nearest = 0;
  std::size_t start = 0;
  const std::vector<double> heading = headings_of(points, axis, nearest, start);
  Index direction = nearest;
  for (std::size_t i = 1; i <= n; ++i) {
    const std::size_t k = (start + i) % n, before = (k + n - 1) % n;
    const Index turn = ((directions[k] - directions[before] + 1) & 3) - 1;
    if (turn > 1) return 1e9;
    turns += turn;
    direction += turn;
    const double angle = sector_angle(points[k], points[(k + 1) % n], points[before]);
    const double off = 2 - turn - fitting_quads(angle);
    price += off * off + (angle >= (170 * pi / 180) * (2 - turn) ? 6 : 0);
    const double away = heading[k] - direction;
    if (i < n) price += 0.2 * std::min(1.0, away * away);
  }
  return turns == 4 ? price : 1e9;
}

bool closes(const std::vector<Index>& directions) {
  LatticePlace place;
  for (const Index d : directions) place = place + lattice_step(d);
  return place == LatticePlace{};
}

/// Of all ways round that close.
double least_price(const std::vector<Vec2>& points, double axis) {
  const std::size_t n = points.size();
  double least = 1e9;
  std::vector<Index> directions(n, 0);
  const auto ways = static_cast<int>(std::pow(3, static_cast<double>(n - 1)) + 0.5);
  for (int way = 0; way < ways; ++way) {
    for (std::size_t k = 1, rest = static_cast<std::size_t>(way); k < n; ++k, rest /= 3)
      directions[k] = directions[k - 1] + static_cast<Index>(rest % 3) - 1;
    if (closes(directions)) least = std::min(least, price_of(points, axis, directions));
  }
  return least;
}

/// A rectangle with round holes of so many edges.
DomainInput plate(Vec2 size, int edges, const std::vector<Vec2>& holes, double radius) {
  DomainInput input;
  auto& loops = input.regions.emplace_back().loops;
  Loop& outer = loops.emplace_back();
  const int nx = static_cast<int>(size.x), ny = static_cast<int>(size.y);
  for (int k = 0; k < nx; ++k) outer.push_back({static_cast<double>(k), 0});
  for (int k = 0; k < ny; ++k) outer.push_back({size.x, static_cast<double>(k)});
  for (int k = 0; k < nx; ++k) outer.push_back({size.x - k, size.y});
  for (int k = 0; k < ny; ++k) outer.push_back({0, size.y - k});
  for (const Vec2 at : holes) {
    Loop& loop = loops.emplace_back();
    for (int k = 0; k < edges; ++k) {
      const double angle = 2 * pi * (k + 0.2) / edges;
      loop.push_back(at + Vec2{radius * std::cos(angle), -radius * std::sin(angle)});
    }
  }
  return input;
}

/// The triangulated domain, in space.
SurfaceSoup soup_of(const Mesher& mesher) {
  SurfaceSoup soup;
  for (const Vec2 p : mesher.triangles().points) {
    const Vec2 q = mesher.frame().to_world(p);
    soup.points.push_back({q.x, q.y, 0});
  }
  soup.triangles = mesher.triangles().triangles;
  return soup;
}

}  // namespace

TEST_CASE("a border turns on the lattice where that costs least", "[grids]") {
  for (int seed = 0; seed < 40; ++seed) {
    const std::vector<Vec2> points = star(4 + 2 * (seed % 4), seed);
    INFO(seed << " with " << points.size() << " points");
    const std::vector<Index> directions = loop_turns(points, 0.1 * seed);
    const double least = least_price(points, 0.1 * seed);
    if (least > 1e8) {
      CHECK(directions.empty());
      continue;
    }
    REQUIRE(directions.size() == points.size());
    CHECK(closes(directions));
    CHECK(price_of(points, 0.1 * seed, directions) <= least + 1e-9);
  }
}

TEST_CASE("an odd border does not close on the lattice", "[grids]") {
  CHECK(loop_turns(star(7, 1), 0).empty());
}

TEST_CASE("loops on the lattice enclose their area in cells", "[grids]") {
  const auto loop = [](std::vector<Index> directions, LatticePlace at, Index first) {
    LatticeLoop line;
    line.nodes.resize(directions.size());
    std::iota(line.nodes.begin(), line.nodes.end(), first);
    for (const Index d : directions) {
      line.places.push_back(at);
      at = at + lattice_step(d);
    }
    return line;
  };
  const auto rectangle = [&](Index width, Index height, LatticePlace at, Index first) {
    std::vector<Index> directions;
    for (const auto& [d, count] : {std::pair{0, width}, {1, height}, {2, width}, {3, height}})
      directions.insert(directions.end(), static_cast<std::size_t>(count), d);
    return loop(directions, at, first);
  };
  const auto quads_of = [](std::vector<LatticeLoop> loops, Index nodes, double most) {
    return lattice_quads({std::move(loops), 0, {}}, nodes, most);
  };
  const LatticeLoop outer = rectangle(5, 4, {-2, 3}, 0);
  const auto hole = [&](LatticePlace at) { return loop({1, 0, 3, 2}, at, 18); };
  const auto quads = quads_of({outer, hole({0, 5})}, 22, 100);
  REQUIRE(quads);
  CHECK(quads->faces.size() == 19);
  CHECK(quads->inside == 12 - 4);
  CHECK_FALSE(quads_of({outer, hole({-2, 5})}, 22, 100));                // touches
  CHECK_FALSE(quads_of({outer, hole({5, 5})}, 22, 100));                 // outside
  CHECK_FALSE(quads_of({outer, rectangle(1, 1, {0, 5}, 18)}, 22, 100));  // filled
  CHECK_FALSE(quads_of({outer, hole({0, 5})}, 22, 20));                  // too large
  CHECK_FALSE(quads_of({outer, hole({0, 5}), hole({0, 5})}, 26, 100));   // twice
}

TEST_CASE("a plate with holes is a grid", "[grids]") {
  const int edges = GENERATE(8, 12);
  const auto mesher =
      Mesher::start(plate({16, 10}, edges, {{4.2, 5.1}, {11.6, 3.3}, {11.9, 7.2}}, 0.16 * edges),
                    {.keep_boundary = true});
  REQUIRE(mesher);
  INFO(mesher->boundary().points.size());
  Mesher chain = *mesher;
  while (chain.stage() != Stage::done) REQUIRE(chain.step());
  const double hole = edges * edges / 16.0;
  const auto grid = grid_of(chain.boundary(), 160 - 3 * hole, chain.triangles());
  REQUIRE(grid);
  check_grid(chain.boundary(), *grid);
  CHECK(static_cast<double>(grid->faces.size()) == 160 - 3 * hole);
  CHECK_FALSE(grid_of(chain.boundary(), 160 - 3 * hole));  // nothing tells where
}

TEST_CASE("a flat part with holes has no irregular vertex inside", "[grids]") {
  // Sizes that leave the sides as many edges as they had.
  auto mesher = Mesher::start(
      plate(
          {26, 12}, 8,
          {{2.6, 2.7}, {2.5, 9.4}, {9.3, 6.2}, {15.6, 2.4}, {15.1, 9.2}, {23.4, 2.6}, {23.3, 9.6}},
          1.28),
      {.keep_boundary = true});
  REQUIRE(mesher);
  REQUIRE(mesher->step());
  const ShellOutcome outcome = meshed(soup_of(*mesher), {.size = 1});
  CHECK(outcome.report.quality.four_valent_percent == 100);
  CHECK(outcome.report.quality.eta_min > 0.5);
}

TEST_CASE("quads at the border are made convex by its nodes", "[grids]") {
  // A hole close to a border whose nodes are a third of a step off those of the hole.
  const auto input = plate({16, 10}, 8, {{4.4, 1.3}, {11.1, 6.5}}, 1.28);
  const auto mesher = Mesher::start(input, {.keep_boundary = true});
  REQUIRE(mesher);
  Mesher chain = *mesher;
  while (chain.stage() != Stage::done) REQUIRE(chain.step());
  const auto grid = grid_of(chain.boundary(), 152, chain.triangles());
  REQUIRE(grid);
  const std::vector<Index> bent = invalid_faces(*grid);
  CHECK(!bent.empty());
  CHECK(bent.size() <= 3);
  for (const Index f : bent) CHECK(touches_border(*grid, grid->faces[f]));
  const ShellOutcome outcome = meshed(soup_of(chain), {.size = 1});
  CHECK(outcome.report.quality.nonconvex == 0);
  CHECK(outcome.report.quality.four_valent_percent == 100);
  CHECK(outcome.report.quality.eta_min > 0.2);
}

TEST_CASE("a face with four balanced sides is a grid", "[grids]") {
  const auto bent = [](Vec2 p) { return Vec2{p.x + 0.2 * p.y, p.y + 0.3 * p.x * (1 - p.x)}; };
  auto points = square({5, 3, 5, 3}, bent);
  const int start = GENERATE(0, 2, 7);  // the loop may begin anywhere
  std::rotate(points.begin(), points.begin() + start, points.end());
  const BoundaryMesh boundary = boundary_of(points);
  const auto grid = grid_of(boundary, 15);
  REQUIRE(grid);
  CHECK(grid->faces.size() == 15);
  CHECK(grid->points.size() == 24);
  check_grid(boundary, *grid);
}

TEST_CASE("a strip one quad wide is a grid without inner vertices", "[grids]") {
  const auto grid = grid_of(boundary_of(square({1, 4, 1, 4}, same)), 4);
  REQUIRE(grid);
  CHECK(grid->faces.size() == 4);
  CHECK(grid->points.size() == 10);
}

TEST_CASE("a face with a hollow corner is a grid", "[grids]") {
  const BoundaryMesh boundary =
      boundary_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}});
  const auto grid = grid_of(boundary, 3);
  REQUIRE(grid);
  CHECK(grid->faces.size() == 3);
  check_grid(boundary, *grid);
}

TEST_CASE("no grid where its number is not what the sizes ask for", "[grids]") {
  const BoundaryMesh boundary = boundary_of(square({20, 20, 20, 20}, same));
  for (const double wanted : {390.0, 400.0, 600.0}) CHECK(grid_of(boundary, wanted));
  for (const double wanted : {50.0, 1000.0}) CHECK_FALSE(grid_of(boundary, wanted));
  CHECK(grid_of(boundary_of(square({1, 1, 1, 1}, same)), 0.01));
}

TEST_CASE("other borders have no grid", "[grids]") {
  SECTION("sides that differ") {
    CHECK_FALSE(grid_of(boundary_of(square({5, 3, 4, 4}, same)), 16));
  }
  SECTION("a hole, and no map") {
    BoundaryMesh boundary = boundary_of(square({4, 4, 4, 4}, same));
    add_loop({{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}}, boundary);
    CHECK_FALSE(grid_of(boundary, 16));
  }
  SECTION("a node inside") {
    BoundaryMesh boundary = boundary_of(square({4, 4, 4, 4}, same));
    boundary.points.push_back({0.5, 0.5});
    CHECK_FALSE(grid_of(boundary, 16));
  }
  SECTION("a wall inside") {
    BoundaryMesh boundary = boundary_of(square({2, 2, 2, 2}, same));
    Segment wall;
    wall.a = 1;
    wall.b = 5;
    wall.left = wall.right = 0;
    boundary.edges.push_back(wall);
    CHECK_FALSE(grid_of(boundary, 16));
  }
}

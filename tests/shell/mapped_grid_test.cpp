// Grids over faces with four sides: which borders have one, and that it is one.
#include "shell/mapped_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "cleanup/quad_topology.h"
#include "cleanup/untangle.h"

using namespace lpq;

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

}  // namespace

TEST_CASE("a face with four balanced sides is a grid", "[shell][grid]") {
  const auto bent = [](Vec2 p) { return Vec2{p.x + 0.2 * p.y, p.y + 0.3 * p.x * (1 - p.x)}; };
  auto points = square({5, 3, 5, 3}, bent);
  const int start = GENERATE(0, 2, 7);  // the loop may begin anywhere
  std::rotate(points.begin(), points.begin() + start, points.end());
  const BoundaryMesh boundary = boundary_of(points);
  const auto grid = mapped_grid(boundary, 15);
  REQUIRE(grid);
  CHECK(grid->faces.size() == 15);
  CHECK(grid->points.size() == 24);
  CHECK(grid->fixed == 16);
  CHECK(std::equal(points.begin(), points.end(), grid->points.begin()));
  CHECK(invalid_faces(*grid).empty());
  const QuadTopology topology{QuadMesh(*grid)};
  for (Index v = grid->fixed; v < topology.vertex_count(); ++v) CHECK(topology.valence(v) == 4);
  for (const Segment& edge : boundary.edges) {
    const bool forward = edge.left != none;
    CHECK(topology.face_with_edge(forward ? edge.a : edge.b, forward ? edge.b : edge.a) != none);
  }
}

TEST_CASE("a strip one quad wide is a grid without inner vertices", "[shell][grid]") {
  const auto grid = mapped_grid(boundary_of(square({1, 4, 1, 4}, same)), 4);
  REQUIRE(grid);
  CHECK(grid->faces.size() == 4);
  CHECK(grid->points.size() == 10);
}

TEST_CASE("no grid where its number is not what the sizes ask for", "[shell][grid]") {
  const BoundaryMesh boundary = boundary_of(square({20, 20, 20, 20}, same));
  for (const double wanted : {390.0, 400.0, 600.0}) CHECK(mapped_grid(boundary, wanted));
  for (const double wanted : {50.0, 1000.0}) CHECK_FALSE(mapped_grid(boundary, wanted));
  CHECK(mapped_grid(boundary_of(square({1, 1, 1, 1}, same)), 0.01));
}

TEST_CASE("other borders have no grid", "[shell][grid]") {
  SECTION("sides that differ") {
    CHECK_FALSE(mapped_grid(boundary_of(square({5, 3, 4, 4}, same)), 16));
  }
  SECTION("a hollow corner") {
    CHECK_FALSE(mapped_grid(
        boundary_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}), 3));
  }
  SECTION("a circle") {
    std::vector<Vec2> points;
    for (int k = 0; k < 16; ++k) points.push_back({std::cos(k * 0.3927), std::sin(k * 0.3927)});
    CHECK_FALSE(mapped_grid(boundary_of(points), 16));
  }
  SECTION("a hole") {
    BoundaryMesh boundary = boundary_of(square({4, 4, 4, 4}, same));
    add_loop({{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}}, boundary);
    CHECK_FALSE(mapped_grid(boundary, 16));
  }
  SECTION("a node inside") {
    BoundaryMesh boundary = boundary_of(square({4, 4, 4, 4}, same));
    boundary.points.push_back({0.5, 0.5});
    CHECK_FALSE(mapped_grid(boundary, 16));
  }
  SECTION("a wall inside") {
    BoundaryMesh boundary = boundary_of(square({2, 2, 2, 2}, same));
    Segment wall;
    wall.a = 1;
    wall.b = 5;
    wall.left = wall.right = 0;
    boundary.edges.push_back(wall);
    CHECK_FALSE(mapped_grid(boundary, 16));
  }
}

// Repair by flips equals a rebuild, call after call, and says when it cannot.
#include "catch.h"
#include "delaunay/delaunay.h"
#include "mesh/validate.h"
#include "support/delaunay_checks.h"

using namespace lpq_test;
using lpq::triangulate;
using lpq::UpdateStatus;

namespace {

struct Tally {
  int flipped = 0, rebuilt = 0, flips = 0;
};

// Moves points at random for many rounds; after each, the mesh must equal a rebuild.
Tally wander(const BoundaryMesh& boundary, int count, double step, int rounds, std::uint64_t seed) {
  auto interior = points_inside(boundary, count, seed, 0.01);
  auto built = triangulate(boundary, interior);
  REQUIRE(built.has_value());
  lpq::TriMesh mesh = *std::move(built);
  lpq::UpdateWorkspace workspace;
  lpq::Rng rng(seed + 1);
  Tally tally;
  for (int round = 0; round < rounds; ++round) {
    auto moved = interior;
    for (Vec2& p : moved) p += Vec2{rng.between(-step, step), rng.between(-step, step)};
    auto rebuilt = triangulate(boundary, moved);
    if (!rebuilt.has_value()) continue;  // a point left the domain
    interior = moved;
    const auto result = update(mesh, interior, &workspace);
    tally.flips += result.flips;
    if (result.status == UpdateStatus::needs_rebuild) {
      ++tally.rebuilt;
      mesh = *std::move(rebuilt);
      continue;
    }
    ++tally.flipped;
    CHECK(lpq::validate(mesh).empty());
    CHECK(same_triangulation(mesh, *rebuilt));
  }
  return tally;
}

}  // namespace

TEST_CASE("small moves are repaired by flips and equal a rebuild") {
  const Tally tally = wander(flower_with_holes(), 300, 0.001, 300, 1);
  CHECK(tally.flipped > 50);
  CHECK(tally.flips > 50);
}

TEST_CASE("larger moves ask for a rebuild when a triangle turns over") {
  const Tally tally = wander(flower_with_holes(60), 60, 0.01, 300, 2);
  CHECK(tally.flipped > 0);
  CHECK(tally.rebuilt > 0);
}

TEST_CASE("walls and regions survive updates") {
  BoundaryMesh boundary = boundary_of({rectangle({-1, -1}, {2, 2})});
  add_polyline(boundary, {{-0.5, 0.5003}, {0.6, 0.51}, {1.5, 0.4998}});
  const Tally tally = wander(boundary, 200, 0.002, 100, 3);
  CHECK(tally.flipped > 20);
  auto mesh = triangulate(boundary, points_inside(boundary, 200, 4, 0.01));
  REQUIRE(mesh.has_value());
  std::vector<Vec2> interior(mesh->points.begin() + mesh->fixed, mesh->points.end());
  CHECK(update(*mesh, interior).flips == 0);
  CHECK(walls_of(*mesh) == expected_walls(boundary));
}

TEST_CASE("an inverted or flat triangle is found") {
  const BoundaryMesh square = boundary_of({rectangle({0, 0}, {1, 1})});
  for (const Vec2 bad : {Vec2{2, 0.5}, Vec2{1, 0.5}, Vec2{0, 0}}) {
    auto mesh = triangulate(square, std::vector<Vec2>{{0.5, 0.5}});
    REQUIRE(mesh.has_value());
    CHECK(update(*mesh, std::vector<Vec2>{bad}).status == UpdateStatus::needs_rebuild);
  }
}

TEST_CASE("ties are left alone") {
  const BoundaryMesh square = boundary_of({rectangle({-1, -1}, {8, 8})});
  std::vector<Vec2> grid = random_grid_points(64, 8, 1);
  auto mesh = triangulate(square, grid);
  REQUIRE(mesh.has_value());
  const auto before = mesh->triangles;
  CHECK(update(*mesh, grid).flips == 0);
  CHECK(mesh->triangles == before);
}

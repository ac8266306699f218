// Untangling by moving vertices.
#include "cleanup/untangle.h"

#include "catch.h"
#include "cleanup/quad_topology.h"
#include "cleanup/star_centre.h"
#include "numerics/elementary.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("the centre of a star is where its kernel is widest") {
  QuadMesh mesh = grid(2, 2);
  const Csr<Index> stars = faces_at_vertices(mesh);
  for (const Vec2 start : {Vec2{0.2, 0.3}, Vec2{1.9, 1.7}, Vec2{2.4, 1.0}, Vec2{-0.5, 1.5}}) {
    mesh.points[8] = start;
    const StarCentre best = star_centre(mesh.points, mesh.faces, stars.row(8), 8, 1);
    CHECK(best.after >= best.before);
    // The kernel is bounded by the four diagonals of the corner quads: a square on its tip.
    CHECK(distance(best.position, {1, 1}) < 1e-9);
    CHECK(best.after == Approx(std::sqrt(0.5)));
  }
}

TEST_CASE("the centre of a star beats every point of a raster") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    QuadMesh mesh = grid(2, 2);
    mesh.fixed = 0;
    mesh = shaken(mesh, 0.3, seed);
    const Csr<Index> stars = faces_at_vertices(mesh);
    const StarCentre best = star_centre(mesh.points, mesh.faces, stars.row(8), 8, 1);
    const Vec2 at = mesh.points[8];
    for (double x = -1; x <= 1; x += 0.125)
      for (double y = -1; y <= 1; y += 0.125) {
        mesh.points[8] = at + Vec2{x, y};
        CHECK(star_centre(mesh.points, mesh.faces, stars.row(8), 8, 1).before <= best.after + 1e-9);
      }
  }
}

TEST_CASE("shaken grids are untangled without moving the boundary") {
  for (const double amount : {0.6, 1.0, 1.5})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const QuadMesh start = shaken(grid(12, 9), amount, seed);
      QuadMesh mesh = start;
      const std::size_t before = invalid_faces(mesh).size();
      REQUIRE(before > 0);
      CHECK(untangle(mesh) == static_cast<Index>(before));
      CHECK(invalid_faces(mesh).empty());
      for (Index v = 0; v < mesh.fixed; ++v) CHECK(mesh.points[v] == start.points[v]);
      CHECK(area_of(mesh) == Approx(12 * 9));
    }
}

TEST_CASE("untangling copes with four orders of magnitude of grading") {
  QuadMesh mesh = grid(16, 6);
  const auto grade = [](double x) { return std::pow(2.0, x); };  // test data only
  for (Vec2& p : mesh.points) p = {grade(p.x) - 1, grade(p.x) * p.y};
  QuadMesh tangled = mesh;
  Rng rng(4);
  for (std::size_t v = mesh.fixed; v < mesh.points.size(); ++v) {
    const double size = 0.7 * (mesh.points[v].x + 1);
    tangled.points[v] += {rng.between(-size, size), rng.between(-size, size)};
  }
  REQUIRE(!invalid_faces(tangled).empty());
  untangle(tangled);
  CHECK(invalid_faces(tangled).empty());
}

TEST_CASE("a valid mesh is left alone, bit for bit") {
  const QuadMesh start = shaken(grid(8, 8), 0.2);
  QuadMesh mesh = start;
  CHECK(untangle(mesh) == 0);
  CHECK(mesh.points == start.points);
}

TEST_CASE("what cannot be untangled does not get worse") {
  // Both wall edges of the corner at vertex 1 lie in one quad and make a straight angle.
  QuadMesh mesh = mesh_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 0.5}},
                          {{0, 1, 2, 5}, {2, 3, 4, 5}, {4, 0, 5, none}}, 5);
  const std::size_t before = invalid_faces(mesh).size();
  REQUIRE(before > 0);
  untangle(mesh);
  CHECK(invalid_faces(mesh).size() <= before);
}

TEST_CASE("a star of very many faces is centred in little time") {
  // Regression: trying all triples of lines took minutes around vertices of high valence.
  const Index petals = 60;
  QuadMesh mesh;
  for (Index i = 0; i < 2 * petals; ++i) {
    const SinCos turn = sin_cos(pi * i / petals);
    mesh.points.push_back({turn.cos, turn.sin});
  }
  mesh.points.push_back({0.3, 0.2});
  mesh.fixed = 2 * petals;
  for (Index i = 0; i < petals; ++i)
    mesh.faces.push_back(
        {2 * petals, 2 * i, 2 * i + 1, static_cast<Index>((2 * i + 2) % (2 * petals))});
  const Csr<Index> stars = faces_at_vertices(mesh);
  const Index centre = 2 * petals;
  const StarCentre best = star_centre(mesh.points, mesh.faces, stars.row(centre), centre, 1);
  CHECK(best.after > best.before);
  CHECK(length(best.position) < 0.05);
}

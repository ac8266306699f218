// Untangling by moving vertices.
#include "cleanup/untangle.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
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

// Corners at random radii, some of them far out, so that the kernel may be large, small or empty
// and the best place be at a side of the box.
QuadMesh random_star(Index petals, std::uint64_t seed) {
  Rng rng(seed);
  QuadMesh mesh;
  for (Index i = 0; i < 2 * petals; ++i) {
    const SinCos turn = sin_cos(pi * (i + 0.8 * rng.unit()) / petals);
    const double radius = (seed % 3 == 0 ? 20 : 1) * (0.2 + rng.unit());
    mesh.points.push_back({radius * turn.cos, radius * turn.sin});
  }
  mesh.points.push_back({rng.unit() - 0.5, rng.unit() - 0.5});
  mesh.fixed = 2 * petals;
  for (Index i = 0; i < petals; ++i)
    mesh.faces.push_back(
        {2 * petals, 2 * i, 2 * i + 1, static_cast<Index>((2 * i + 2) % (2 * petals))});
  return mesh;
}

TEST_CASE("no place in the box is better than the centre of a star of any size") {
  for (const Index petals : {3, 4, 5, 6, 9, 15})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      QuadMesh mesh = random_star(petals, seed);
      const Csr<Index> stars = faces_at_vertices(mesh);
      const Index v = 2 * petals;
      const auto centre = [&] { return star_centre(mesh.points, mesh.faces, stars.row(v), v, 1); };
      const StarCentre best = centre();
      const Vec2 at = mesh.points[v];
      CHECK(std::max(std::abs(best.position.x - at.x), std::abs(best.position.y - at.y)) <
            2 + 1e-9);
      mesh.points[v] = best.position;
      CHECK(centre().before == Approx(best.after).margin(1e-9));
      // The least distance is concave: what is nowhere better nearby is nowhere better.
      for (const double step : {0.5, 0.01})
        for (int k = 0; k < 32; ++k) {
          const SinCos turn = sin_cos(2 * pi * k / 32);
          const Vec2 there = best.position + step * Vec2{turn.cos, turn.sin};
          if (std::max(std::abs(there.x - at.x), std::abs(there.y - at.y)) > 2) continue;
          mesh.points[v] = there;
          CHECK(centre().before <= best.after + 1e-9);
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

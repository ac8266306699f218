// Distances between mesh and surface: against all triangles one by one, and where they are known.
#include "shell/distance.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "shell/mesh_surface.h"
#include "shell/nearest_triangle.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// The nearest point by walking over the weights of a triangle, to see that none is nearer.
double sampled_distance(Vec3 p, Vec3 a, Vec3 b, Vec3 c, int n) {
  double least = 1e300;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Vec3 q = a + (double(i) / n) * (b - a) + (double(j) / n) * (c - a);
      least = std::min(least, distance(p, q));
    }
  return least;
}

Vec3 random_point(Rng& rng) {
  const double x = rng.between(-1, 1), y = rng.between(-1, 1), z = rng.between(-1, 1);
  return {x, y, z};
}

/// A single quad over the square [0, 1]^2.
ShellMesh one_quad(double z0, double z1, double z2, double z3) {
  ShellMesh mesh;
  mesh.points = {{0, 0, z0}, {1, 0, z1}, {1, 1, z2}, {0, 1, z3}};
  mesh.faces = {{0, 1, 2, 3}};
  return mesh;
}

}  // namespace

TEST_CASE("no point of a triangle is nearer than the nearest") {
  Rng rng(7);
  for (int k = 0; k < 300; ++k) {
    const Vec3 p = random_point(rng), a = random_point(rng), b = random_point(rng);
    const Vec3 c = k % 3 == 0 ? midpoint(a, b) : random_point(rng);  // some without area
    const double found = distance(p, nearest_in_triangle(p, a, b, c));
    const double sampled = sampled_distance(p, a, b, c, 60);
    CHECK(found <= sampled + 1e-12);
    CHECK(found >= sampled - 0.1);
  }
  CHECK(nearest_in_triangle({1, 2, 3}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}) == Vec3{1, 1, 1});
}

TEST_CASE("the tree finds what a look at every triangle finds") {
  const SurfaceMesh mesh = torus(24, 12, 1, 0.4);
  const NearestTriangle tree(mesh.points, mesh.triangles);
  Rng rng(3);
  for (int k = 0; k < 200; ++k) {
    // Vertices too: their triangles are equally near, and the first counts.
    const Vec3 p = k % 4 == 0 ? mesh.points[static_cast<std::size_t>(k)] : random_point(rng);
    NearestTriangle::Hit best{none, {}, 1e300};
    for (Index t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.triangles[t];
      const Vec3 q = nearest_in_triangle(p, mesh.points[a], mesh.points[b], mesh.points[c]);
      if (squared_length(q - p) < best.squared_distance) best = {t, q, squared_length(q - p)};
    }
    for (const Index hint : {0, mesh.triangle_count() - 1, mesh.triangle_count() / 2}) {
      const auto hit = tree.find(p, hint);
      CHECK(hit.triangle == best.triangle);
      CHECK(hit.squared_distance == best.squared_distance);
    }
  }
}

TEST_CASE("a raised quad is as far as it is raised") {
  const SurfaceMesh square = plane_square(4);
  const auto flat = surface_distance(square.points, square.triangles, one_quad(2, 2, 2, 2));
  CHECK(flat.to_surface.max == 2);
  CHECK(std::abs(flat.to_surface.mean - 2) < 1e-12);
  CHECK(flat.from_surface.max == 2);
  CHECK(std::abs(flat.from_surface.mean - 2) < 1e-12);
  // One corner up by 1: bilinear, a quarter in the mean.
  const auto bent = surface_distance(square.points, square.triangles, one_quad(0, 0, 1, 0));
  CHECK(bent.to_surface.max == 1);
  CHECK(std::abs(bent.to_surface.mean - 0.25) < 0.04);
}

TEST_CASE("half of a surface without mesh is seen from the surface only") {
  const SurfaceMesh square = grid_surface(8, 4, [](double u, double v) {
    return Vec3{2 * u, v, 0};
  });
  const auto half = surface_distance(square.points, square.triangles, one_quad(0, 0, 0, 0));
  CHECK(half.to_surface.max == 0);
  CHECK(half.from_surface.max == 1);
  CHECK(std::abs(half.from_surface.mean - 0.25) < 0.02);
}

TEST_CASE("what lies inside large triangles is measured, and said where") {
  SurfaceMesh square;  // in the middle of which the mesh dips
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  ShellMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -0.25}};
  for (Index k = 0; k < 4; ++k) mesh.faces.push_back({k, (k + 1) % 4, 4, none});
  const Distance distance = surface_distance(square.points, square.triangles, mesh).from_surface;
  CHECK(distance.max > 0.12);  // 0.22, and less between samples
  CHECK(distance.max <= 0.25);
  CHECK(lpq::distance(distance.at, {0.5, 0.5, 0}) < 0.2);
  CHECK(distance.mean > 0.05);
}

TEST_CASE("chords of a sphere stay within their sagitta", "[slow]") {
  const SurfaceMesh ball = sphere(24);
  SurfaceSoup soup;
  soup.points = ball.points;
  soup.triangles = ball.triangles;
  const double h = 0.2;
  const auto outcome = mesh_surface(soup, {.size = h});
  REQUIRE(outcome.has_value());
  const SurfaceDistance& distance = outcome->report.distance;
  // Half a diagonal off: (1.6 h / sqrt 2)^2 / 2, and the triangles' own chords.
  CHECK(distance.to_surface.max < 0.65 * h * h);
  CHECK(distance.to_surface.mean < 0.3 * h * h);
  CHECK(distance.to_surface.mean > 0.02 * h * h);
  CHECK(distance.from_surface.max < 0.65 * h * h);
  const auto finer = mesh_surface(soup, {.size = h / 2});
  REQUIRE(finer.has_value());
  CHECK(finer->report.distance.to_surface.mean < 0.5 * distance.to_surface.mean);
}

// The coarse surface that windows work on, and the way there and back.
#include "shell/coarse_ground.h"

#include <cmath>

#include "catch.h"
#include "field/field.h"
#include "shell/nearby_places.h"
#include "shell/place.h"
#include "support/surface_meshes.h"
#include "surface/frames.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// A ball with nothing on it but a size, and crosses where they are asked for.
struct Ball {
  SurfaceMesh mesh;
  SurfaceFeatures features;
  SurfaceCrossField cross;
  std::vector<double> size;
  Atlas atlas;
  SurfaceCurves curves;
  CurveMesh nodes;

  Ball(int n, double h) : mesh(sphere(n)), size(mesh.points.size(), h) {
    features = find_features(mesh, size);
  }
  void solve_crosses() { cross = solve_surface_cross(mesh, features.half_edges()); }
  Charted charted() const { return {mesh, features, cross, size, atlas, features, curves, nodes}; }
};

ShellMesh scattered(const SurfaceMesh& mesh) {
  ShellMesh shell;
  for (Index t = 0; t < mesh.triangle_count(); t += 37) {
    shell.places.push_back({t, {0.5, 0.2, 0.3}});
    shell.points.push_back(point_at(mesh, shell.places.back()));
    shell.pins.push_back(t % 3 == 0 ? Pin::line : Pin::free);
  }
  return shell;
}

}  // namespace

TEST_CASE("only what is much finer than its mesh gets a coarse ground") {
  const Ball fine(100, 0.15), ordinary(30, 0.15), quads(100, 0.05);
  CHECK(wants_coarse_ground(fine.charted()));
  CHECK(!wants_coarse_ground(ordinary.charted()));
  CHECK(!wants_coarse_ground(quads.charted()));
}

TEST_CASE("vertices go to the coarse ground and back") {
  Ball ball(40, 0.3);
  ball.solve_crosses();
  const CoarseGround ground(ball.charted());
  const Charted coarse = ground.charted();
  CHECK(4 * coarse.mesh.triangle_count() < ball.mesh.triangle_count());
  REQUIRE(coarse.cross.z.size() == coarse.mesh.triangles.size());
  for (const Vec2 z : coarse.cross.z) CHECK(std::abs(length(z) - 1) < 1e-9);
  const ShellMesh before = scattered(ball.mesh);
  ShellMesh mesh = before;
  ground.lower(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    CHECK(mesh.points[v] == before.points[v]);
    CHECK(distance(point_at(coarse.mesh, mesh.places[v]), mesh.points[v]) < 0.02);
    if (mesh.is_free(v)) mesh.points[v] = point_at(coarse.mesh, mesh.places[v]);
  }
  ground.raise(before, mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (!mesh.is_free(v))
      CHECK(mesh.places[v].triangle == before.places[v].triangle);
    else
      CHECK(mesh.points[v] == point_at(ball.mesh, mesh.places[v]));
    CHECK(distance(mesh.points[v], before.points[v]) < 0.02);
  }
}

TEST_CASE("crosses on the coarse ground are those of the surface") {
  // On a flat square they run along its sides, whatever the triangles.
  Ball flat(4, 0.2);
  flat.mesh = plane_square(40);
  flat.size.assign(flat.mesh.points.size(), 0.2);
  flat.features = find_features(flat.mesh, flat.size);
  flat.solve_crosses();
  const CoarseGround ground(flat.charted());
  const Charted coarse = ground.charted();
  for (Index t = 0; t < coarse.mesh.triangle_count(); ++t) {
    const Vec3 x = axes_of(coarse.mesh, t).x, y = axes_of(coarse.mesh, t).y;
    const Vec2 along = cross_of({x.x, y.x});
    CHECK(length(coarse.cross.z[t] - along) < 1e-6);
  }
}

TEST_CASE("places nearby are on the sheet that they are asked for on") {
  // Two squares on top of each other, nearer than their triangles are large.
  SurfaceMesh sheets = plane_square(10);
  const Index half = sheets.vertex_count(), triangles = sheets.triangle_count();
  for (Index v = 0; v < half; ++v) sheets.points.push_back(sheets.points[v] + Vec3{0, 0, 0.01});
  for (Index t = 0; t < triangles; ++t) {
    const auto [a, b, c] = sheets.triangles[t];
    sheets.triangles.push_back({a + half, b + half, c + half});
  }
  const std::vector<Index> face(2 * static_cast<std::size_t>(triangles), 0);
  const NearbyPlaces places(sheets, face);
  const Index corners[] = {half};
  const SurfacePlace place = places.nearest({0.83, 0.61, 0}, 0, corners);
  CHECK(place.triangle >= triangles);
  CHECK(distance(point_at(sheets, place), {0.83, 0.61, 0.01}) < 1e-12);
}

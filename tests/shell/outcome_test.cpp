// What a run tells of its mesh: quads that are good ones in themselves and yet lie wrong.
#include "shell/outcome.h"

#include <string>
#include <vector>

#include "catch.h"
#include "numerics/elementary.h"
#include "shell/quality.h"
#include "support/meshed_surface.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// A flat strip of unit squares.
SurfaceMesh strip(int squares) {
  return grid_surface(squares, 1, [=](double u, double v) { return Vec3{squares * u, v, 0}; });
}

SurfacePlace place_of(const SurfaceMesh& surface, Vec3 p) {
  for (Index e = 0; e < 3 * surface.triangle_count(); ++e)
    if (surface.points[surface.origin(e)] == p) {
      SurfacePlace place{triangle_of(e), {0, 0, 0}};
      place.weight[e % 3] = 1;
      return place;
    }
  return {};
}

/// Quads across the strip, from one x to the next.
ShellOutcome summary(const std::vector<double>& at) {
  ShellOutcome outcome;
  outcome.surface = strip(4);
  ShellMesh& mesh = outcome.mesh;
  for (const double x : at)
    for (const double y : {0.0, 1.0}) {
      mesh.points.push_back({x, y, 0});
      mesh.places.push_back(place_of(outcome.surface, mesh.points.back()));
    }
  mesh.pins.assign(mesh.points.size(), Pin::line);
  for (Index k = 0; k + 1 < static_cast<Index>(at.size()); ++k)
    mesh.faces.push_back({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
  mesh.face.assign(mesh.faces.size(), 0);
  const std::vector<double> size(outcome.surface.points.size(), 1);
  summarise(find_features(outcome.surface, size), {}, size, outcome);
  return outcome;
}

std::string told(const ShellOutcome& outcome) {
  for (const Warning& warning : outcome.report.warnings)
    if (warning.message.starts_with("Quads that look against the surface")) return warning.message;
  return {};
}

/// Two boxes side by side, whose walls in one place are divided along different diagonals.
SurfaceSoup boxes_with_a_wall_between() {
  SurfaceSoup soup = box_soup({1, 1, 1}, 1);
  const auto first = static_cast<Index>(soup.points.size());
  const SurfaceSoup other = soup;
  for (const Vec3 p : other.points) soup.points.push_back({2 - p.x, 1 - p.y, p.z});
  for (const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({a + first, b + first, c + first});
  return soup;
}

/// A pipe and, in the same place, the wall of a hole that it fills, divided elsewhere.
SurfaceSoup pipe_in_its_hole() {
  SurfaceSoup soup = soup_of(cylinder(96, 4, 1, 2));
  const auto first = static_cast<Index>(soup.points.size());
  const SinCos t = sin_cos(0.1 * turn / 96);
  const SurfaceSoup pipe = soup;
  for (const Vec3 p : pipe.points)
    soup.points.push_back({t.cos * p.x - t.sin * p.y, t.sin * p.x + t.cos * p.y, p.z});
  for (const auto& [a, b, c] : pipe.triangles)
    soup.triangles.push_back({a + first, c + first, b + first});
  return soup;
}

}  // namespace

TEST_CASE("quads that are turned over are told of, although each is a good quad") {
  const ShellOutcome sound = summary({0, 1, 2, 3, 4});
  CHECK(told(sound).empty());
  const ShellOutcome folded = summary({0, 1, 3, 2, 4});
  CHECK(folded.report.quality.nonconvex == 0);
  CHECK(told(folded).starts_with(
      "Quads that look against the surface: 1, the first near (3, 0, 0)."));
  CHECK(told(summary({0, 3, 2, 4, 1})).find(": 2, the first near (3, 0, 0).") != std::string::npos);
}

TEST_CASE("walls in one place, thin sheets and sharp edges are no folds") {
  const ShellOutcome boxes = meshed(boxes_with_a_wall_between(), {.size = 0.2});
  CHECK(boxes.surface.triangle_count() == 24);  // the wall is there twice
  CHECK(told(boxes).empty());
  for (const double size : {1.0, 1.2, 1.4})
    CHECK(told(meshed(pipe_in_its_hole(), {.size = size})).empty());
  CHECK(told(meshed(box_soup({1, 1, 0.001}, 1), {.size = 0.2})).empty());
  SurfaceSoup wedge = box_soup({2, 2, 0.1}, 1);
  for (Vec3& p : wedge.points) p.z *= p.x;
  CHECK(told(meshed(wedge, {.size = 0.2})).empty());
}

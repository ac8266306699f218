// Sheets, parts and bodies that meet: in a point, along an edge, along a side.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "numerics/elementary.h"
#include "shell/topology.h"
#include "support/meshed_surface.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// The sides of a pyramid whose tip is its last vertex.
SurfaceSoup spire(Index sides) {
  SurfaceSoup soup;
  for (int i = 0; i < sides; ++i)
    soup.points.push_back(
        {0.25 * std::cos(2 * pi * i / sides), 0.25 * std::sin(2 * pi * i / sides), 0});
  soup.points.push_back({0, 0, 1});
  for (Index i = 0; i < sides; ++i) soup.triangles.push_back({i, (i + 1) % sides, sides});
  return soup;
}

void mesh_spires_that_go_on(double size) {
  for (const Index sides : {3, 4, 5}) {
    SurfaceSoup soup = spire(sides);
    soup.points.push_back(2 * soup.points[0] - soup.points[1]);
    soup.triangles.push_back({0, sides, sides + 1});
    // Creases are no features, so that one chart goes round the tip, on one line on both sides.
    const auto outcome = mesh_surface(soup, {.size = size, .feature_angle = 180});
    REQUIRE(outcome.has_value());
    CHECK(check_shell(outcome->surface, outcome->mesh).empty());
  }
}

}  // namespace

TEST_CASE("parts of a surface that meet in a point keep that point") {
  SurfaceSoup soup = soup_of(sphere(8));
  const SurfaceSoup ball = soup;
  const auto top = std::max_element(ball.points.begin(), ball.points.end(),
                                    [](Vec3 a, Vec3 b) { return a.z < b.z; });
  const Index shift = static_cast<Index>(ball.points.size());
  for (const Vec3 p : ball.points) soup.points.push_back({p.x, p.y, 2 * top->z - p.z});
  for (const auto& [a, b, c] : ball.triangles)
    soup.triangles.push_back({a + shift, c + shift, b + shift});
  const ShellOutcome outcome = meshed(soup, {.size = 0.25});
  CHECK(outcome.report.repair.nonmanifold_vertices == 1);
  CHECK(std::count(outcome.mesh.points.begin(), outcome.mesh.points.end(), *top) == 1);
}

TEST_CASE("a rib that ends inside a plate is an edge of both") {
  // Straight, tilted, and on a cone whose tip is the rib's end.
  for (const Vec3 up : {Vec3{0, 0, 1}, Vec3{0.6, 0, 0.8}}) {
    const Vec3 along{up.z, 0, -up.x};
    SurfaceSoup soup;
    const std::vector<Vec3> flat{{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0},
                                 {2, 3, 0}, {8, 3, 0},  {2, 3, 2},  {8, 3, 2}};
    for (const Vec3 p : flat) soup.points.push_back(p.x * along + Vec3{0, p.y, 0} + p.z * up);
    soup.triangles = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5},
                      {3, 4, 5}, {3, 0, 4}, {4, 5, 7}, {4, 7, 6}};
    const ShellOutcome outcome = meshed(soup, {.size = 0.4});
    CHECK(outcome.report.faces == 2);
    CHECK(outcome.report.quality.eta_mean > 0.95);
    CHECK(shell_topology(outcome.mesh.faces).meeting_edges >= 15);
  }
  SurfaceSoup fin = spire(12);
  fin.points.push_back({0.5, 0, 1});
  fin.triangles.push_back({0, 12, 13});
  const ShellOutcome outcome = meshed(fin, {.size = 0.06});
  CHECK(outcome.report.quality.eta_min > 0.1);
}

TEST_CASE("a spire one side of which goes on past its edge has a mesh up to its tip") {
  mesh_spires_that_go_on(0.2);
}

TEST_CASE("such a spire has a mesh of small quads, too", "[slow]") { mesh_spires_that_go_on(0.05); }

TEST_CASE("sheets that meet along one edge inside them keep it as an edge of both") {
  // Two tents that share their ridge: four triangles on it, all of one part.
  SurfaceSoup soup;
  soup.points = {{0, 0, 0},   {1, 0, 0},    {0.5, 1, -1}, {0.5, -1, -1},
                 {0.5, 1, 1}, {0.5, -1, 1}, {3, 1, 0},    {3, -1, 0}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}, {0, 1, 5},
                    {1, 6, 2}, {1, 4, 6}, {1, 3, 7}, {1, 7, 5}};
  const ShellOutcome outcome = meshed(soup, {.size = 0.15});
  CHECK(outcome.report.repair.nonmanifold_edges == 1);
  CHECK(shell_topology(outcome.mesh.faces).meeting_edges >= 4);
}

TEST_CASE("bodies that share a side get closed meshes, each as if it were alone") {
  const SurfaceOptions options{.size = 0.2};
  const ShellOutcome pair = meshed(touching_boxes(2), options);
  const ShellOutcome alone = meshed(box_soup({1, 1, 1}, 2), options);
  CHECK(pair.report.rounds == 1);
  CHECK(pair.report.repair.components == 2);
  const ShellTopology topology = shell_topology(pair.mesh.faces);
  CHECK(topology.components == 2);
  CHECK(topology.border_edges + topology.meeting_edges + topology.pinches == 0);
  CHECK(topology.euler == 4);
  REQUIRE(pair.report.bodies.size() == 2);
  Index vertices = 0, quads = 0;
  for (const BodyReport& body : pair.report.bodies) {
    CHECK(body.parts == 1);
    CHECK(body.border_edges == 0);
    CHECK(body.triangles == 0);
    CHECK(body.vertices == body.quads + 2);  // Euler, of a sphere
    vertices += body.vertices;
    quads += body.quads;
  }
  CHECK(vertices == static_cast<Index>(pair.mesh.points.size()));
  CHECK(quads == pair.report.quality.quads);
  CHECK(pair.report.bodies[0].quads == alone.report.quality.quads);
  CHECK(pair.report.bodies[1].name == "body 2");
  CHECK(alone.report.bodies.empty());
}

TEST_CASE("a face that touches itself in a point is laid out flat in pieces") {
  // A plate with a pit that comes to a point on its edge, where a wall goes down: to the surface a
  // vertex like others, to the plate two corners in one place. Turned so that rounding lays the one
  // a hair beyond the other.
  SurfaceSoup soup;
  soup.points = {{0, 0, 0}, {0, 2, 0}, {0, -2, 0}, {4, -2, 0}, {4, 2, 0},
                 {2, 1, 0}, {3, 0, 0}, {2, -1, 0}, {2, 0, -1}, {0, 0, -3}};
  soup.triangles = {{0, 5, 1}, {5, 4, 1}, {5, 6, 4}, {6, 3, 4}, {7, 3, 6}, {7, 2, 3}, {0, 2, 7},
                    {0, 8, 5}, {5, 8, 6}, {6, 8, 7}, {7, 8, 0}, {1, 9, 0}, {0, 9, 2}};
  const double a = 0.3, b = 0.5;
  for (Vec3& p : soup.points) {
    p = {std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z};
    p = {p.x, std::cos(b) * p.y - std::sin(b) * p.z, std::sin(b) * p.y + std::cos(b) * p.z};
  }
  const ShellOutcome outcome = meshed(soup, {.size = 0.3});
  CHECK(outcome.report.repair.nonmanifold_vertices == 0);
  CHECK(outcome.report.faces == 6);
  CHECK(outcome.report.quality.nonconvex == 0);
  CHECK(std::count(outcome.mesh.points.begin(), outcome.mesh.points.end(), Vec3{0, 0, 0}) == 1);
}

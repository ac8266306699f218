// Windows: balls that are disks, what they know of the mesh around them, and what comes back.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "cleanup/ideal_valence.h"
#include "numerics/elementary.h"
#include "shell/chart_fields.h"
#include "shell/mesh_surface.h"
#include "shell/place.h"
#include "shell/rework.h"
#include "support/map_checks.h"
#include "support/surface_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

constexpr double everywhere = 1e6;

bool is_disk(const SurfaceMesh& mesh, const Ball& ball) {
  const std::vector<char> uncut(mesh.twins.size(), 0);
  return lpq_test::is_disk(PartTaker(mesh).take(ball.triangles, uncut));
}

bool contains(const Ball& ball, Index t) {
  return std::binary_search(ball.triangles.begin(), ball.triangles.end(), t);
}

/// Two discs of `n` corners and the band between them.
SurfaceSoup thin_disc(Index n, double radius, double thickness) {
  constexpr Index rings = 3;
  SurfaceSoup soup;
  for (const double z : {0.5 * thickness, -0.5 * thickness}) {
    soup.points.push_back({0, 0, z});
    for (Index ring = 1; ring <= rings; ++ring)
      for (Index k = 0; k < n; ++k) {
        const double angle = 2 * pi * k / n, r = radius * ring / rings;
        soup.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
      }
  }
  const Index below = 1 + rings * n;
  const auto both = [&](Index a, Index b, Index c) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({below + c, below + b, below + a});
  };
  for (Index k = 0; k < n; ++k) {
    const Index next = (k + 1) % n;
    both(0, 1 + k, 1 + next);
    for (Index a = 1 + k, b = 1 + next; a + n < below; a += n, b += n) {
      both(a, a + n, b + n);
      both(a, b + n, b);
    }
    const Index a = below - n + k, b = below - n + next;
    soup.triangles.push_back({a, below + a, below + b});
    soup.triangles.push_back({a, below + b, b});
  }
  return soup;
}

/// Marks the edges of a pipe that run along it at angle 0, between two shares of its height.
std::vector<char> line_along(const SurfaceMesh& pipe, double height, double from, double to) {
  std::vector<char> line(pipe.twins.size(), 0);
  const auto on_line = [&](Vec3 p) {
    return p.x > 0 && p.y == 0 && p.z >= from * height && p.z <= to * height;
  };
  for (Index e = 0; e < static_cast<Index>(line.size()); ++e)
    line[e] = pipe.twins[e] == none ||
              (on_line(pipe.points[pipe.origin(e)]) && on_line(pipe.points[pipe.target(e)]));
  return line;
}

ShellOutcome meshed_sphere() {
  SurfaceSoup soup;
  const SurfaceMesh mesh = sphere(12);
  soup.points = mesh.points;
  soup.triangles = mesh.triangles;
  soup.group_names = {""};
  auto outcome = mesh_surface(soup, {.size = 0.1});
  REQUIRE(outcome.has_value());
  return *std::move(outcome);
}

Index irregular(const QuadMesh& mesh) {
  const QuadTopology topology{QuadMesh(mesh)};
  const IdealValence ideal(topology);
  Index count = 0;
  for (Index v = 0; v < topology.vertex_count(); ++v) count += !ideal.is_regular(topology, v);
  return count;
}

}  // namespace

TEST_CASE("a ball is a disk, however large, and covers nearly all of a closed surface") {
  const SurfaceMesh mesh = torus(48, 24, 1, 0.4);
  const std::vector<char> barrier(mesh.twins.size(), 0);
  BallFinder finder(mesh, barrier);
  for (const double radius : {0.3, 1.0, 2.0, everywhere}) {
    const Ball ball = finder.ball(100, radius, 0);
    CHECK(is_disk(mesh, ball));
    CHECK(contains(ball, 100));
  }
  CHECK(10 * finder.ball(0, everywhere, 0).triangles.size() > 9 * mesh.triangles.size());
}

TEST_CASE("a ball goes round a line that ends inside it, but not across one that does not") {
  const SurfaceMesh pipe = cylinder(24, 20, 0.5, 2);
  for (const bool ends : {true, false}) {
    const std::vector<char> line = line_along(pipe, 2, ends ? 0.3 : 0, ends ? 0.7 : 1);
    const Ball ball = BallFinder(pipe, line).ball(0, everywhere, 0);
    CHECK(is_disk(pipe, ball));
    for (Index e = 0; e < static_cast<Index>(line.size()); ++e) {
      if (!line[e] || pipe.twins[e] == none) continue;
      const int sides = contains(ball, triangle_of(e)) + contains(ball, triangle_of(pipe.twins[e]));
      CHECK(sides == (ends ? 2 : 1));
    }
  }
}

TEST_CASE("the margin of a ball lies along its open border, not along barriers") {
  const SurfaceMesh mesh = plane_square(20);
  std::vector<char> barrier(mesh.twins.size());
  for (std::size_t e = 0; e < barrier.size(); ++e) barrier[e] = mesh.twins[e] == none;
  BallFinder finder(mesh, barrier);
  const Ball all = finder.ball(0, everywhere, 0.2);
  CHECK(std::count(all.inside.begin(), all.inside.end(), 0) == 0);
  const Ball some = finder.ball(400, 0.4, 0.1);
  CHECK(std::count(some.inside.begin(), some.inside.end(), 1) > 0);
  for (std::size_t i = 0; i < some.triangles.size(); ++i)
    for (Index e = 3 * some.triangles[i]; e < 3 * some.triangles[i] + 3; ++e)
      if (!barrier[e] && !contains(some, triangle_of(mesh.twins[e]))) CHECK(!some.inside[i]);
}

TEST_CASE("a window counts the quads around it and keeps its rim when it is reworked") {
  const ShellOutcome outcome = meshed_sphere();
  const SurfaceMesh& surface = outcome.surface;
  const std::vector<char> feature(surface.twins.size(), 0);
  const std::vector<double> size(surface.points.size(), 0.1);
  const SurfaceCrossField cross = solve_surface_cross(surface, feature);
  BallFinder balls(surface, feature);
  WindowMaker windows(surface, cross, size);
  const ShellStars stars(outcome.mesh, surface.triangle_count());
  const auto window = windows.open(outcome.mesh, stars, balls.ball(0, 0.8, 0.15));
  REQUIRE(window.has_value());
  std::vector<Index> valence(outcome.mesh.points.size(), 0), inside(window->vertex.size(), 0);
  for (const Face& face : outcome.mesh.faces)
    for (const Index v : face) ++valence[v];
  for (const Face& face : window->quads.faces)
    for (const Index v : face) ++inside[v];
  for (Index v = 0; v < window->quads.fixed; ++v)
    CHECK(inside[v] + window->quads.outside[v] == valence[window->vertex[v]]);
  if (const auto better = rework(*window, Rework::knot, {}, 1)) {
    REQUIRE(better->fixed == window->quads.fixed);
    for (Index v = 0; v < better->fixed; ++v) CHECK(better->points[v] == window->quads.points[v]);
    CHECK(irregular(*better) <= irregular(window->quads));
  }
}

TEST_CASE("points beyond a chart's border go to its nearest point") {
  const SurfaceMesh mesh = plane_square(4);
  const std::vector<char> feature(mesh.twins.size(), 0);
  const Atlas atlas = make_charts(mesh, feature);
  REQUIRE(atlas.charts.size() == 1);
  const Chart& chart = atlas.charts[0];
  const std::vector<double> size(mesh.points.size(), 0.25);
  const Fields fields = chart_fields(mesh, solve_surface_cross(mesh, feature), size, chart);
  const auto& points = chart.plane.points;
  Vec2 centre;
  for (const Vec2 p : points) centre += (1.0 / static_cast<double>(points.size())) * p;
  for (const Vec2 corner : points)
    for (const double times : {1.0, 1.3, 2.5}) {
      const Vec2 p = centre + times * (corner - centre);
      Index hint = none;
      const SurfacePlace place = place_on(chart, fields, p, hint);
      const auto at =
          std::lower_bound(chart.triangles.begin(), chart.triangles.end(), place.triangle);
      Vec2 q;
      for (int k = 0; k < 3; ++k)
        q += place.weight[k] * points[chart.plane.triangles[at - chart.triangles.begin()][k]];
      // The square is convex: nearest means that nothing lies further towards p.
      for (const Vec2 other : points) CHECK(dot(other - q, p - q) < 1e-9);
    }
}

TEST_CASE("windows over a thin rim leave no quad folded over it") {
  // Two discs, far nearer to each other than quads are long, and the band between: no feature.
  const auto disc = thin_disc(14, 10, 0.1);
  const auto outcome = mesh_surface(disc, {.size = 0.8, .feature_angle = 100});
  REQUIRE(outcome.has_value());
  CHECK(outcome->report.quality.nonconvex == 0);
  CHECK(outcome->report.quality.eta_min > 0.3);
}

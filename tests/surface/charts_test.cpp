// Charts of whole surfaces: every promise on every surface, and few charts where few will do.
#include "surface/charts/charts.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "geometry/predicates.h"
#include "support/map_checks.h"
#include "support/shared_surfaces.h"
#include "support/surface_meshes.h"
#include "surface/components.h"

using namespace lpq;
using namespace lpq_test;

namespace {

void check_borders(const SurfaceMesh& mesh, const Atlas& atlas, const Chart& chart) {
  std::size_t walls = 0;
  for (Index e = 0; e < 3 * chart.plane.triangle_count(); ++e) {
    const Index there = chart.on_surface(e);
    CHECK(mesh.origin(there) == chart.vertex[chart.plane.origin(e)]);
    CHECK((chart.plane.twins[e] == none) == (atlas.cut[there] != 0));
    walls += chart.plane.twins[e] == none;
    if (chart.plane.twins[e] != none)
      CHECK(chart.on_surface(chart.plane.twins[e]) == mesh.twins[there]);
  }
  CHECK(chart.borders.values.size() == walls);
  for (Index loop = 0; loop < chart.borders.rows(); ++loop) {
    const auto chain = chart.borders.row(loop);
    for (std::size_t i = 0; i < chain.size(); ++i)
      CHECK(mesh.target(chain[i]) == mesh.origin(chain[(i + 1) % chain.size()]));
  }
}

void check_map_of(const Chart& chart) {
  const auto& p = chart.plane.points;
  Index flipped = 0;
  for (const auto& [a, b, c] : chart.plane.triangles) flipped += orient2d(p[a], p[b], p[c]) <= 0;
  CHECK(flipped == 0);
  CHECK(chart.method != MapMethod::none_found);
  CHECK(is_injective(chart.check));
  CHECK(chart.check.within(MapLimits{}));
  // None is far larger or smaller in the plane than on the surface.
  const auto [small, large] = std::minmax_element(chart.scale.begin(), chart.scale.end());
  CHECK(*small <= 1.5);
  CHECK(*large >= 1 / 1.5);
  Index edges = 0;
  for (Index e = 0; e < 3 * chart.plane.triangle_count(); ++e) edges += chart.plane.twins[e] < e;
  const Index chi = chart.plane.vertex_count() - edges + chart.plane.triangle_count();
  CHECK(chi == 2 - chart.borders.rows());
}

Atlas checked_charts(const SurfaceMesh& mesh, const std::vector<char>& feature) {
  Atlas atlas = make_charts(mesh, feature);
  CHECK(atlas.counts.rejected == 0);
  std::vector<int> seen(mesh.triangles.size(), 0);
  const Components faces = components_of(mesh.twins, feature);
  for (const Chart& chart : atlas.charts) {
    for (const Index t : chart.triangles) {
      ++seen[t];
      CHECK(faces.of_triangle[t] == chart.face);
    }
    check_borders(mesh, atlas, chart);
    check_map_of(chart);
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == mesh.triangle_count());
  return atlas;
}

}  // namespace

TEST_CASE("the faces of a cube are its charts") {
  const SurfaceMesh mesh = cube(5);
  const Atlas atlas = checked_charts(mesh, sharp_edges(mesh));
  CHECK(atlas.charts.size() == 6);
  for (const Chart& chart : atlas.charts) CHECK(chart.check.scale_range < 1 + 1e-9);
}

TEST_CASE("a long pipe is one chart, unrolled") {
  const SurfaceMesh mesh = cylinder(24, 160, 1, 40);
  const Atlas atlas = checked_charts(mesh, sharp_edges(mesh));
  REQUIRE(atlas.charts.size() == 1);
  CHECK(atlas.counts.opened == 1);
  CHECK(atlas.charts[0].check.scale_range < 1 + 1e-9);
  const int inner = static_cast<int>(std::count(atlas.cut.begin(), atlas.cut.end(), 1));
  CHECK(inner == 2 * 24 + 2 * 160);
}

TEST_CASE("closed surfaces are cut into few charts") {
  const SurfaceMesh ball = sphere(12), ring = torus(48, 16, 3, 1);
  CHECK(checked_charts(ball, std::vector<char>(ball.twins.size(), 0)).charts.size() <= 4);
  CHECK(checked_charts(ring, std::vector<char>(ring.twins.size(), 0)).charts.size() <= 6);
}

TEST_CASE("a ramp that winds over itself is cut") {
  // Flat, but more than a full turn round: unrolled, it covers itself.
  const SurfaceMesh ramp = grid_surface(120, 6, [](double u, double v) {
    const double angle = -1.6 * turn * u, r = 1 + v;
    return Vec3{r * std::cos(angle), r * std::sin(angle), 0.05 * u};
  });
  const Atlas atlas = checked_charts(ramp, std::vector<char>(ramp.twins.size(), 0));
  CHECK(atlas.counts.crossings > 0);
  CHECK(atlas.charts.size() >= 2);
  CHECK(atlas.charts.size() <= 4);
}

TEST_CASE("a ball with a pinhole is split without being mapped first") {
  SurfaceMesh ball = sphere(20);
  ball.triangles.pop_back();
  ball.group.pop_back();
  ball = SurfaceBuilder().build(ball.points, ball.triangles);
  const Atlas atlas = checked_charts(ball, std::vector<char>(ball.twins.size(), 0));
  CHECK(atlas.counts.maps < 12);
}

TEST_CASE("a feature that ends inside a face is no cut") {
  const SurfaceMesh mesh = plane_square(8);
  std::vector<char> feature(mesh.twins.size(), 0);
  Index marked = 0;
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Vec3 a = mesh.points[mesh.origin(e)], b = mesh.points[mesh.target(e)];
    if (a.y == 0.5 && b.y == 0.5 && a.x < 0.6 && b.x < 0.6) feature[e] = 1, ++marked;
  }
  REQUIRE(marked > 0);
  const Atlas atlas = checked_charts(mesh, feature);
  CHECK(atlas.charts.size() == 1);
  CHECK(std::count(atlas.cut.begin(), atlas.cut.end(), 1) == 32);
}

TEST_CASE("charts are the same bits on every run, and scale by powers of two exactly") {
  const SurfaceMesh mesh = torus(40, 14, 3, 1);
  SurfaceMesh large = mesh;
  for (Vec3& p : large.points) p = 1024.0 * p;
  const std::vector<char> feature(mesh.twins.size(), 0);
  const Atlas a = make_charts(mesh, feature), b = make_charts(mesh, feature);
  const Atlas c = make_charts(large, feature);
  REQUIRE(a.charts.size() == b.charts.size());
  REQUIRE(a.charts.size() == c.charts.size());
  for (std::size_t i = 0; i < a.charts.size(); ++i) {
    CHECK(a.charts[i].plane.points == b.charts[i].plane.points);
    CHECK(a.charts[i].triangles == c.charts[i].triangles);
    std::vector<Vec2> scaled;
    for (const Vec2 p : a.charts[i].plane.points) scaled.push_back(1024.0 * p);
    CHECK(scaled == c.charts[i].plane.points);
  }
}

namespace {

void sweep(Index least, Index most) {
  const auto files = shared_surfaces();
  if (files.empty()) WARN("SKIPPED: nothing tested here because there are no shared surfaces");
  Index charts = 0, conformal = 0;
  for (const auto& file : files) {
    const SurfaceMesh mesh = read_obj(file);
    if (mesh.triangle_count() < least || mesh.triangle_count() >= most) continue;
    INFO(file);
    for (const Chart& chart : checked_charts(mesh, sharp_edges(mesh)).charts) {
      ++charts;
      conformal += chart.method == MapMethod::bff || chart.method == MapMethod::lscm;
    }
  }
  CHECK(conformal >= 0.99 * charts);
}

}  // namespace

TEST_CASE("every small shared surface is charted") { sweep(0, 3000); }
TEST_CASE("every shared surface is charted", "[slow]") { sweep(3000, 1 << 30); }

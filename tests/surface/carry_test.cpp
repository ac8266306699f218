// Crosses and sizes of the surface seen in the planes of its charts.
#include "surface/charts/carry.h"

#include <cmath>

#include "catch.h"
#include "field/field.h"
#include "support/shared_surfaces.h"
#include "support/surface_meshes.h"
#include "surface/cross_field.h"
#include "surface/frames.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("crosses of a pipe are one cross in the plane, and its cut does not count") {
  const SurfaceMesh mesh = cylinder(30, 40, 1, 12);
  const std::vector<char> feature = sharp_edges(mesh);
  const SurfaceCrossField field = solve_surface_cross(mesh, feature);
  const Atlas atlas = make_charts(mesh, feature);
  REQUIRE(atlas.charts.size() == 1);
  const std::vector<Vec2> z = crosses_in_plane(mesh, atlas.charts[0], field.z);
  for (const Vec2 value : z) CHECK(length(value - z[0]) < 1e-6);
  // Along the unrolled border.
  const Chart& chart = atlas.charts[0];
  for (Index e = 0; e < 3 * chart.plane.triangle_count(); ++e) {
    if (mesh.twins[chart.on_surface(e)] != none) continue;
    const Vec2 side =
        chart.plane.points[chart.plane.target(e)] - chart.plane.points[chart.plane.origin(e)];
    CHECK(length(cross_of(side) - z[0]) < 1e-6);
  }
}

TEST_CASE("what a plane is stretched by is told, and crosses are those without it") {
  const SurfaceMesh mesh = sphere_cap(8, 1);
  const std::vector<char> feature(mesh.twins.size(), 0);
  const SurfaceCrossField field = solve_surface_cross(mesh, feature);
  Atlas atlas = make_charts(mesh, feature);
  REQUIRE(atlas.charts.size() == 1);
  Chart& chart = atlas.charts[0];
  // A conformal map of one triangle, so that its neighbours do not matter.
  for (std::size_t t = 0; t < chart.triangles.size(); t += 7) {
    const TriangleLayout layout = layout_of(mesh, chart.triangles[t]);
    const auto [a, b, c] = chart.plane.triangles[t];
    chart.plane.points[a] = {0, 0};
    chart.plane.points[b] = complex_product({0.6, 0.9}, layout.side[0]);
    chart.plane.points[c] = complex_product({0.6, 0.9}, -layout.side[2]);
    const Vec2 z = crosses_in_plane(mesh, chart, field.z)[t], mu{-0.2, 0.3};
    CHECK(length(stretches_in_plane(mesh, chart)[t]) < 1e-12);
    for (const Index v : {b, c}) chart.plane.points[v] = stretched(chart.plane.points[v], -mu);
    CHECK(length(stretches_in_plane(mesh, chart)[t] - mu) < 1e-12);
    CHECK(length(crosses_in_plane(mesh, chart, field.z)[t] - z) < 1e-12);
    chart.plane.points[c] = chart.plane.points[b] + 1e-3 * perpendicular(chart.plane.points[b]);
    CHECK(length(stretches_in_plane(mesh, chart)[t]) <= most_stretch * (1 + 1e-12));
  }
}

TEST_CASE("sizes count as many quads in the planes as on the surface") {
  const SurfaceMesh mesh = sphere(16);
  const std::vector<char> feature(mesh.twins.size(), 0);
  const std::vector<double> h(mesh.points.size(), 0.1);
  double count = 0;
  for (const Chart& chart : make_charts(mesh, feature).charts) {
    const std::vector<double> plane = sizes_in_plane(mesh, chart, h);
    for (const auto& [a, b, c] : chart.plane.triangles) {
      const auto& p = chart.plane.points;
      const double mean = (plane[a] + plane[b] + plane[c]) / 3;
      count += 0.5 * cross(p[b] - p[a], p[c] - p[a]) / (mean * mean);
    }
  }
  CHECK(std::abs(count / (100 * surface_area(mesh)) - 1) < 0.02);
}

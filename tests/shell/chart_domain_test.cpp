// Charts as plane domains: what is a feature inside becomes polylines without gaps.
#include "shell/chart_domain.h"

#include <algorithm>

#include "catch.h"
#include "numerics/elementary.h"
#include "shell/curve_nodes.h"
#include "support/surface_meshes.h"
#include "surface/curves.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

namespace {

constexpr Index sectors = 24, rings = 4;

/// A disk in the plane; ring k has the points k sectors - sectors + 1 .. k sectors. What
/// is inside ring 2 is a group.
SurfaceMesh disk() {
  SurfaceSoup soup;
  soup.points = {{0, 0, 0}};
  const auto at = [](Index ring, Index k) {
    return ring == 0 ? 0 : 1 + (ring - 1) * sectors + k % sectors;
  };
  for (Index ring = 1; ring <= rings; ++ring)
    for (Index k = 0; k < sectors; ++k) {
      const SinCos t = sin_cos(2 * pi * k / sectors);
      soup.points.push_back({t.cos * ring, t.sin * ring, 0});
    }
  for (Index ring = 0; ring < rings; ++ring)
    for (Index k = 0; k < sectors; ++k) {
      soup.triangles.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
      if (ring > 0) soup.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    soup.group.push_back(t < 3 * sectors ? 0 : 1);
  soup.group_names = {"inside", "outside"};
  return repair_surface(soup)->mesh;
}

}  // namespace

TEST_CASE(
    "a loop of features inside a chart is closed, wherever it begins and whatever it has cut") {
  const SurfaceMesh mesh = disk();
  const std::vector<double> size(mesh.points.size(), 0.7);
  const SurfaceFeatures features = find_features(mesh, size);
  const SurfaceCurves curves = trace_curves(mesh, features);
  const auto nodes = mesh_curves(mesh, features, curves, size);
  REQUIRE(nodes.has_value());
  const SurfaceFeatures borders = find_features(mesh, size, {.groups = false});
  Atlas atlas = make_charts(mesh, borders.half_edges());
  REQUIRE(atlas.charts.size() == 1);
  const CurveNodes at(mesh, features.edges, curves, *nodes);

  const auto lines = [&] {
    return chart_domain(mesh, features, curves, atlas, atlas.charts[0], at).input.polylines;
  };
  REQUIRE(lines().size() == 1);
  const Loop loop = lines()[0].points;
  CHECK(loop.front() == loop.back());
  double shortest = distance(loop[0], loop[1]), longest = shortest;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    shortest = std::min(shortest, distance(loop[i - 1], loop[i]));
    longest = std::max(longest, distance(loop[i - 1], loop[i]));
  }
  CHECK(longest < 1.5 * shortest);
  // With a piece of it cut, whichever it is, the rest is one line.
  const std::vector<char> uncut = atlas.cut;
  for (Index i = 0; i < features.edges.count(); ++i) {
    if (features.kind[i] != FeatureKind::group_border) continue;
    for (const Index e : features.edges.half_edges.row(i)) atlas.cut[e] = 1;
    CHECK(lines().size() == 1);
    CHECK(lines()[0].points.size() < loop.size());
    CHECK(lines()[0].points.size() > loop.size() / 2);
    atlas.cut = uncut;
  }
}

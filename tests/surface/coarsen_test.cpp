// Coarse surfaces against what they stand for.
#include "surface/coarsen.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "catch.h"
#include "support/surface_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

std::vector<char> sharp_of_cube(const SurfaceMesh& mesh) {
  std::vector<char> sharp(mesh.twins.size(), 0);
  const auto sides = [&](Vec3 p) {
    return (std::abs(p.x) == 1) + (std::abs(p.y) == 1) + (std::abs(p.z) == 1);
  };
  for (Index e = 0; e < static_cast<Index>(sharp.size()); ++e) {
    const Vec3 a = mesh.points[mesh.origin(e)], b = mesh.points[mesh.target(e)];
    sharp[e] = sides(a) > 1 && sides(b) > 1 && sides(midpoint(a, b)) > 1;
  }
  return sharp;
}

void check_twins(const SurfaceMesh& mesh) {
  for (Index e = 0; e < static_cast<Index>(mesh.twins.size()); ++e) {
    const Index twin = mesh.twins[e];
    if (twin == none) continue;
    CHECK(mesh.twins[twin] == e);
    CHECK(mesh.origin(twin) == mesh.target(e));
    CHECK(mesh.target(twin) == mesh.origin(e));
  }
}

CoarseSurface checked_coarse(const SurfaceMesh& mesh, const std::vector<char>& feature,
                             double longest) {
  const std::vector<double> sides(mesh.points.size(), longest);
  CoarseSurface coarse = coarsen(mesh, feature, sides);
  check_twins(coarse.mesh);
  CHECK(euler(coarse.mesh) == euler(mesh));
  for (Index v = 0; v < coarse.mesh.vertex_count(); ++v) {
    CHECK(coarse.mesh.points[v] == mesh.points[coarse.vertex[v]]);
    CHECK(coarse.home[coarse.vertex[v]] == v);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    CHECK(distance(mesh.points[v], coarse.mesh.points[coarse.home[v]]) < 2 * longest);
  for (Index e = 0; e < static_cast<Index>(coarse.mesh.twins.size()); ++e)
    CHECK(distance(coarse.mesh.points[coarse.mesh.origin(e)],
                   coarse.mesh.points[coarse.mesh.target(e)]) <= longest);
  return coarse;
}

}  // namespace

TEST_CASE("a ball becomes coarse as far as sides may be long") {
  const SurfaceMesh ball = sphere(40);
  const std::vector<char> smooth(ball.twins.size(), 0);
  const CoarseSurface coarse = checked_coarse(ball, smooth, 0.3);
  CHECK(10 * coarse.mesh.triangle_count() < ball.triangle_count());
  CHECK(surface_area(coarse.mesh) > 0.97 * surface_area(ball));
  const std::vector<double> shorter(ball.points.size(), 0.01);  // than any side
  CHECK(coarsen(ball, smooth, shorter).mesh.triangles == ball.triangles);
}

TEST_CASE("features stay when a surface becomes coarse, edge by edge") {
  const SurfaceMesh box = cube(30);
  const std::vector<char> sharp = sharp_of_cube(box);
  const CoarseSurface coarse = checked_coarse(box, sharp, 0.5);
  CHECK(4 * coarse.mesh.triangle_count() < box.triangle_count());
  std::set<std::array<Index, 2>> before, after;
  for (Index e = 0; e < static_cast<Index>(sharp.size()); ++e)
    if (sharp[e]) before.insert({box.origin(e), box.target(e)});
  for (Index e = 0; e < static_cast<Index>(coarse.feature.size()); ++e)
    if (coarse.feature[e])
      after.insert({coarse.vertex[coarse.mesh.origin(e)], coarse.vertex[coarse.mesh.target(e)]});
  CHECK(before == after);
  // No triangle went from one side of the cube to another.
  const auto side_of = [](const SurfaceMesh& mesh, Index t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 n = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    return (1 / length(n)) * n;
  };
  for (Index t = 0; t < coarse.mesh.triangle_count(); ++t)
    CHECK(dot(side_of(coarse.mesh, t), side_of(box, coarse.triangle[t])) > 0.999);
}

TEST_CASE("walls stay when a surface becomes coarse") {
  const SurfaceMesh pipe = cylinder(60, 60, 1, 4);
  const CoarseSurface coarse = checked_coarse(pipe, std::vector<char>(pipe.twins.size(), 0), 0.5);
  CHECK(3 * coarse.mesh.triangle_count() < pipe.triangle_count());
  CHECK(std::count(coarse.mesh.twins.begin(), coarse.mesh.twins.end(), none) == 120);
}

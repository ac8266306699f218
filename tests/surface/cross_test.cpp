// The cross field of a surface: exact where it is known, and its singularities always add up.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "field/field.h"
#include "support/shared_surfaces.h"
#include "support/surface_meshes.h"
#include "surface/cross_field.h"
#include "surface/fans.h"

using namespace lpq;
using namespace lpq_test;

namespace {

int total_index(const SurfaceCrossField& field) {
  int sum = 0;
  for (const SurfaceSingularity& s : field.singularities) sum += s.index;
  return sum;
}

// |sin| of twice the angle between an arm of the cross and a direction: 0 where they agree.
double misfit(const SurfaceMesh& mesh, const SurfaceCrossField& field, Index t, Vec3 direction) {
  const TriangleAxes axes = axes_of(mesh, t);
  const Vec2 d{dot(direction, axes.x), dot(direction, axes.y)};
  return length(field.z[t] - cross_of(d));
}

bool closed(const SurfaceMesh& mesh) {
  for (const Index twin : mesh.twins)
    if (twin == none) return false;
  return true;
}

}  // namespace

TEST_CASE("a flat square has one cross everywhere, however it lies in space") {
  SurfaceMesh mesh = plane_square(12);
  const Vec3 x{0.6, 0.8, 0}, y{0, 0, 1};
  for (Vec3& p : mesh.points) p = p.x * x + p.y * y;
  const SurfaceCrossField field = solve_surface_cross(mesh, {});
  for (Index t = 0; t < mesh.triangle_count(); ++t) CHECK(misfit(mesh, field, t, x) < 1e-9);
  CHECK(field.singularities.empty());
}

TEST_CASE("crosses of a cylinder run along and across it") {
  const SurfaceMesh mesh = cylinder(40, 30, 1, 4);
  const SurfaceCrossField field = solve_surface_cross(mesh, sharp_edges(mesh));
  for (Index t = 0; t < mesh.triangle_count(); ++t) CHECK(misfit(mesh, field, t, {0, 0, 1}) < 1e-6);
  CHECK(field.singularities.empty());
}

TEST_CASE("a cube is singular at its corners alone") {
  const SurfaceMesh mesh = cube(6);
  const SurfaceCrossField field = solve_surface_cross(mesh, sharp_edges(mesh));
  REQUIRE(field.singularities.size() == 8);
  for (const SurfaceSingularity& s : field.singularities) {
    const Vec3 p = mesh.points[s.vertex];
    CHECK(s.index == 1);
    CHECK(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) == 3);
  }
}

TEST_CASE("without a constraint the field is smooth and its indices sum to 4 chi") {
  const SurfaceCrossField round = solve_surface_cross(sphere(10), {});
  CHECK(round.singularities.size() == 8);
  CHECK(total_index(round) == 8);
  CHECK(total_index(solve_surface_cross(torus(40, 16, 3, 1), {})) == 0);
}

TEST_CASE("crosses of surfaces too large to be solved for at once are as smooth", "[slow]") {
  const SurfaceMesh ball = sphere(76);  // 69,312 triangles
  const SurfaceCrossField round = solve_surface_cross(ball, {});
  CHECK(round.singularities.size() == 8);
  CHECK(total_index(round) == 8);
  const SurfaceMesh pipe = cylinder(300, 120, 1, 4);
  const SurfaceCrossField along = solve_surface_cross(pipe, sharp_edges(pipe));
  double worst = 0;
  for (Index t = 0; t < pipe.triangle_count(); ++t)
    worst = std::max(worst, misfit(pipe, along, t, {0, 0, 1}));
  CHECK(worst < 0.05);
  CHECK(along.singularities.empty());
  CHECK(total_index(solve_surface_cross(torus(400, 90, 3, 1), {})) == 0);
}

TEST_CASE("several bodies, some free and some not, are each solved for") {
  SurfaceMesh mesh = sphere(6);
  const SurfaceMesh second = cylinder(20, 10, 1, 1), third = sphere(4);
  for (const SurfaceMesh* other : {&second, &third}) {
    const Index v = mesh.vertex_count(), e = 3 * mesh.triangle_count();
    for (const Vec3 p : other->points) mesh.points.push_back(p + Vec3{5, 0, 0});
    for (const auto& [a, b, c] : other->triangles) mesh.triangles.push_back({a + v, b + v, c + v});
    for (const Index twin : other->twins) mesh.twins.push_back(twin == none ? none : twin + e);
    mesh.group.resize(mesh.triangles.size(), 0);
  }
  const SurfaceCrossField field = solve_surface_cross(mesh, {});
  CHECK(total_index(field) == 16);
  for (const Vec2 z : field.z) CHECK(std::abs(length(z) - 1) < 1e-12);
}

TEST_CASE("random crosses still have indices that sum to 4 chi") {
  const SurfaceMesh meshes[] = {sphere(5), torus(20, 10, 3, 1), cube(4)};
  const int sums[] = {8, 0, 8};
  for (int i = 0; i < 3; ++i) {
    SurfaceCrossField field;
    for (Index t = 0; t < meshes[i].triangle_count(); ++t)
      field.z.push_back(cross_of({std::cos(1.7 * t * t), std::sin(1.7 * t * t)}));
    field.singularities = find_surface_singularities(meshes[i], field.z);
    CHECK(field.singularities.size() > 20);
    CHECK(total_index(field) == sums[i]);
  }
}

TEST_CASE("the same surface has the same field, bit for bit") {
  const SurfaceMesh mesh = sphere(8);
  const SurfaceCrossField a = solve_surface_cross(mesh, {}), b = solve_surface_cross(mesh, {});
  CHECK(a.z == b.z);
}

TEST_CASE("the indices of the shared closed surfaces sum to 4 chi", "[slow]") {
  const auto files = shared_surfaces();
  if (files.empty()) WARN("SKIPPED: nothing tested here because there are no shared surfaces");
  int seen = 0;
  for (const auto& file : files) {
    const SurfaceMesh mesh = read_obj(file);
    if (mesh.triangle_count() > 12000 || !closed(mesh)) continue;
    INFO(file);
    const SurfaceFans fans = fans_of(mesh.twins);
    const int chi = fans.count() - mesh.triangle_count() / 2;  // vertices may be pinched
    CHECK(total_index(solve_surface_cross(mesh, sharp_edges(mesh))) == 4 * chi);
    ++seen;
  }
  if (!files.empty()) CHECK(seen > 20);
}

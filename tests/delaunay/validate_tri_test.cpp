// The check of triangulations must find every kind of damage.
#include "catch.h"
#include "mesh/validate.h"
#include "support/delaunay_checks.h"

using namespace lpq_test;

namespace {

TriMesh sound() {
  const BoundaryMesh boundary = flower_with_holes(60);
  auto mesh = lpq::triangulate(boundary, points_inside(boundary, 50, 1, 0.02));
  REQUIRE(mesh.has_value());
  return *std::move(mesh);
}

}  // namespace

TEST_CASE("damage to a triangulation is found") {
  TriMesh mesh = sound();
  REQUIRE(lpq::validate(mesh).empty());
  SECTION("lengths") { mesh.region.pop_back(); }
  SECTION("index") { mesh.triangles[3][1] = mesh.vertex_count(); }
  SECTION("orientation") { std::swap(mesh.triangles[3][0], mesh.triangles[3][1]); }
  SECTION("turned over") { mesh.points.back() = mesh.points[0] + Vec2{5, 5}; }
  SECTION("region") { mesh.region[7] = none; }
  SECTION("twin") {
    for (Index& twin : mesh.twins) {
      if (twin != none) {
        twin = none;
        break;
      }
    }
  }
  SECTION("region border without a wall") {
    for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
      if (mesh.twins[e] != none) {
        mesh.region[lpq::triangle_of(e)] = 1;
        break;
      }
    }
  }
  SECTION("a wall at a free vertex") {
    for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
      if (mesh.origin(e) < mesh.fixed) continue;
      mesh.twins[mesh.twins[e]] = none;
      mesh.twins[e] = none;
      break;
    }
  }
  SECTION("an unused free vertex") { mesh.points.push_back({0, 0}); }
  CHECK(!lpq::validate(mesh).empty());
}

TEST_CASE("the list of violations is limited") {
  TriMesh mesh = sound();
  for (Index& region : mesh.region) region = none;
  CHECK(lpq::validate(mesh, 4).size() == 4);
}

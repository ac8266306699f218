#include "catch.h"
#include "geometry/predicates.h"
#include "recombine/fans.h"
#include "recombine/prepare_corners.h"
#include "recombine/recombine.h"
#include "support/mesh_checks.h"
#include "support/tiny_meshes.h"

using namespace lpq;
using namespace lpq_test;
using lpq_test::Approx;

namespace {

Index missing_triangles(const TriMesh& mesh) {
  Index sum = 0;
  for (const Fan& fan : find_fans(mesh).list)
    if (!fan.closed) sum += std::max<Index>(0, fan.ideal - fan.triangles);
  return sum;
}

}  // namespace

TEST_CASE("an ear over a nearly straight vertex gets a second triangle") {
  //        4-------3
  //       / \     / \ .
  //      /   \   /   \ .        vertex 1 lies a hair below the line 0-2; its only
  //     0 ---- 5 ---- 2         triangle 0 1 2 would make a quad with a 177 degree corner
  //       ` - _1_ - '
  TriMesh mesh = make_tri_mesh({{0, 0}, {1, -0.02}, {2, 0}, {1.5, 1}, {0.5, 1}},
                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, 5);
  CHECK(missing_triangles(mesh) == 1);
  const double area = signed_area(mesh);
  CHECK(prepare_corners(mesh) == 1);
  CHECK(missing_triangles(mesh) == 0);
  CHECK(signed_area(mesh) == Approx(area));
}

TEST_CASE("nothing is flipped where every vertex has enough") {
  TriMesh mesh = grid_triangles(5, 5);
  CHECK(prepare_corners(mesh) == 0);
}

TEST_CASE("walls are not flipped") {
  TriMesh mesh = make_tri_mesh({{0, 0}, {1, -0.02}, {2, 0}, {1.5, 1}, {0.5, 1}},
                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, 5, {{0, 2}});
  CHECK(prepare_corners(mesh) == 0);
}

TEST_CASE("preparing never makes more triangles missing and keeps a triangulation") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    TriMesh mesh = grid_triangles(8, 6, seed % 2 == 0);
    shuffle_edges(mesh, rng, 400);
    for (int k = 0; k < 12; ++k) cut(mesh, static_cast<Index>(rng.below(mesh.twins.size())));
    const DirectedEdges boundary = outer_boundary(mesh);
    const Index before = missing_triangles(mesh);
    const Index flips = prepare_corners(mesh);
    const Index after = missing_triangles(mesh);
    CHECK((flips == 0 ? after == before : after < before));
    CHECK(outer_boundary(mesh) == boundary);
    for (const Tri& t : mesh.triangles)
      REQUIRE(orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) > 0);
  }
}

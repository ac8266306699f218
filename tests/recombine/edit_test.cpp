#include "recombine/edit.h"

#include "catch.h"
#include "geometry/predicates.h"
#include "mesh/walk.h"
#include "recombine/fans.h"
#include "support/mesh_checks.h"
#include "support/tiny_meshes.h"

using namespace lpq;
using namespace lpq_test;
using lpq_test::Approx;

namespace {

void check_links(const TriMesh& mesh) {
  REQUIRE(mesh.twins.size() == 3 * mesh.triangles.size());
  REQUIRE(mesh.region.size() == mesh.triangles.size());
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Index twin = mesh.twins[e];
    if (twin == none) continue;
    REQUIRE(mesh.twins[twin] == e);
    REQUIRE(mesh.origin(twin) == mesh.target(e));
    REQUIRE(mesh.target(twin) == mesh.origin(e));
  }
}

}  // namespace

TEST_CASE("random flips and splits keep links, orientation and area") {
  TriMesh mesh = grid_triangles(6, 5, true);
  Rng rng(7);
  const double area = signed_area(mesh);
  for (int round = 0; round < 6; ++round) {
    shuffle_edges(mesh, rng, 20);
    split_triangle(mesh, static_cast<Index>(rng.below(mesh.triangles.size())));
    check_links(mesh);
    for (const Tri& t : mesh.triangles)
      REQUIRE(orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) > 0);
    CHECK(signed_area(mesh) == Approx(area).epsilon(1e-13));
  }
  CHECK(mesh.triangle_count() == 60 + 12);
}

TEST_CASE("flipping twice exchanges the two triangles' corners and nothing else") {
  TriMesh mesh = grid_triangles(2, 1);
  const Index e = [&] {
    for (Index i = 0; i < 3 * mesh.triangle_count(); ++i)
      if (is_flippable(mesh, i)) return i;
    return none;
  }();
  REQUIRE(e != none);
  const Index a = mesh.origin(e), b = mesh.target(e), left = mesh.apex(e);
  const Index s = triangle_of(mesh.twins[e]), t = triangle_of(e);
  flip_edge(mesh, e);
  check_links(mesh);
  CHECK((triangle_of(mesh.twins[3 * t + 1]) == s));
  flip_edge(mesh, 3 * t + 1);
  check_links(mesh);
  Tri corners = mesh.triangles[t];
  std::sort(corners.begin(), corners.end());
  Tri other = mesh.triangles[s];
  std::sort(other.begin(), other.end());
  Tri expected{a, b, left};
  std::sort(expected.begin(), expected.end());
  CHECK((corners == expected || other == expected));
}

TEST_CASE("walls and reflex pairs are not flippable") {
  //        2
  //       /|\ .       3 lies on the left of edge 0-1, so flipping 1-2 in
  //      / 3 \ .      triangles 0 1 3 ... would turn a triangle over
  //     / / \ \ .
  //    0-------1
  TriMesh mesh =
      make_tri_mesh({{0, 0}, {4, 0}, {2, 4}, {2, 1}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 3);
  for (Index e = 0; e < 9; ++e) CHECK(!is_flippable(mesh, e));
  mesh = grid_triangles(1, 1);
  int flippable = 0;
  for (Index e = 0; e < 6; ++e) flippable += is_flippable(mesh, e);
  CHECK(flippable == 2);
}

TEST_CASE("fans: closed inside, open at walls, one per side of a wall") {
  //   6---7---8
  //   | / | / |     numbered as in a plain grid here: 4 is the inner vertex
  //   3---4---5
  //   | / | / |
  //   0---1---2
  TriMesh mesh = grid_triangles(2, 2);
  const Index inner = mesh.fixed;
  Fans fans = find_fans(mesh);
  CHECK(fans.list.size() == 9);
  Index closed = 0, corners = 0;
  for (const Fan& fan : fans.list) {
    closed += fan.closed;
    corners += fan.triangles;
    CHECK(mesh.origin(fan.first) == mesh.origin(fan.last));
    if (fan.closed)
      CHECK((mesh.origin(fan.first) == inner && fan.triangles == 6 && fan.ideal == 4));
    if (!fan.closed) CHECK(mesh.twins[fan.first] == none);
    if (!fan.closed) CHECK(mesh.twins[prev_in_triangle(fan.last)] == none);
  }
  CHECK(closed == 1);
  CHECK(corners == 3 * mesh.triangle_count());
  // A wall from the rim to the inner vertex: the inner vertex keeps one fan, now open (a full
  // turn).
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e)
    if (mesh.origin(e) == inner && mesh.points[mesh.target(e)] == Vec2{1, 0.5}) cut(mesh, e);
  fans = find_fans(mesh);
  CHECK(fans.list.size() == 10);
  const Index leaving = outgoing_half_edges(mesh)[inner];
  const Fan& turn = fans.list[fans.of_corner[leaving]];
  CHECK(!turn.closed);
  CHECK(turn.triangles == 6);
  CHECK(turn.ideal == 4);
}

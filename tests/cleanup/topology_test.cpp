// Editable connectivity, and the removal of doublets.
#include "cleanup/topology.h"

#include "catch.h"
#include "cleanup/quad_topology.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("an unedited mesh comes back as it was") {
  const QuadMesh mesh = grid(3, 2);
  const QuadMesh back = QuadTopology(mesh).compact();
  CHECK(back.faces == mesh.faces);
  CHECK(back.points == mesh.points);
  CHECK(back.fixed == mesh.fixed);
}

TEST_CASE("faces are found by their directed edges") {
  const QuadTopology mesh(grid(2, 2));
  for (Index f = 0; f < mesh.face_slots(); ++f)
    for (Index k = 0; k < 4; ++k)
      CHECK(mesh.face_with_edge(mesh.face(f)[k], mesh.face(f)[(k + 1) & 3]) == f);
  CHECK(mesh.face_with_edge(1, 0) == none);
  CHECK(!mesh.is_wall(0, 1));
}

TEST_CASE("compaction drops dead faces and unused free vertices, never fixed ones") {
  QuadTopology mesh(grid(2, 2));
  const Index centre = 8;
  REQUIRE(mesh.valence(centre) == 4);
  while (mesh.valence(centre) > 0) mesh.remove_face(mesh.faces_of(centre)[0]);
  const QuadMesh left = std::move(mesh).compact();
  CHECK(left.faces.empty());
  CHECK(left.region.empty());
  CHECK(left.points.size() == 8);
  CHECK(left.fixed == 8);
}

//  3-----2      3-----2
//  |   / |      |     |
//  |  4  |  ->  |     |     vertex 4 has the edges to 0 and 2 only
//  | /   |      |     |
//  0-----1      0-----1
TEST_CASE("a doublet is removed") {
  QuadTopology mesh(
      mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.5}}, {{0, 1, 2, 4}, {0, 4, 2, 3}}, 4));
  CHECK(remove_doublets(mesh) == 1);
  const QuadMesh result = std::move(mesh).compact();
  REQUIRE(result.faces.size() == 1);
  CHECK(result.points.size() == 4);
  CHECK(is_strictly_convex(result.points, result.faces[0]));
}

TEST_CASE("removing a doublet may make the next one") {
  // A stack of nested doublets 0 - x_i - 2.
  QuadMesh mesh = mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, 4);
  Index before = 1;
  for (int i = 1; i <= 5; ++i) {
    mesh.points.push_back({0.9 - 0.15 * i, 0.15 * i});
    const Index x = static_cast<Index>(mesh.points.size()) - 1;
    mesh.faces.push_back({0, before, 2, x});
    before = x;
  }
  mesh.faces.push_back({0, before, 2, 3});
  mesh.region.assign(mesh.faces.size(), 0);
  QuadTopology topology(mesh);
  CHECK(remove_doublets(topology) == 5);
  CHECK(std::move(topology).compact().faces.size() == 1);
}

TEST_CASE("no doublet is removed at fixed vertices or across regions") {
  QuadMesh mesh =
      mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.5}}, {{0, 1, 2, 4}, {0, 4, 2, 3}}, 4);
  QuadMesh pinned = mesh, split = mesh;
  pinned.fixed = 5;
  split.region = {0, 1};
  QuadTopology one(pinned), two(split);
  CHECK(remove_doublets(one) == 0);
  CHECK(remove_doublets(two) == 0);
}

TEST_CASE("strict convexity is exact and more than rounding") {
  const double tiny = 0x1p-40, rounding = 0x1p-52;
  const std::vector<Vec2> points{{0, 0},
                                 {1, 0},
                                 {1, 1},
                                 {0.5, 0.5},
                                 {0.5 - tiny, 0.5 + tiny},
                                 {0.5 - rounding, 0.5 + rounding},
                                 {1, rounding}};
  CHECK(!is_strictly_convex(points, {0, 1, 2, 3}));
  CHECK(is_strictly_convex(points, {0, 1, 2, 4}));
  CHECK(is_strictly_convex(points, {0, 1, 2, none}));
  // In the caller's coordinates these may be flat or turn the other way.
  CHECK(!is_strictly_convex(points, {0, 1, 2, 5}));
  CHECK(!is_strictly_convex(points, {0, 1, 6, 2}));
}

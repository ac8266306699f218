// Patches grow until their outline bends outwards only, and never over walls.
#include "patches/growth.h"

#include <algorithm>

#include "catch.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

Index vertex_at(const QuadTopology& mesh, Vec2 p) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.point(v) == p) return v;
  return none;
}

}  // namespace

//  +--+--+--+          +--+--+--+
//  |  |xx|  |          |xx|xx|  |    the vertex in the middle has three quads of the patch:
//  +--+--+--+    ->    +--+--+--+    the fourth joins
//  |xx|xx|  |          |xx|xx|  |
TEST_CASE("a corner that bends inwards is filled") {
  const QuadTopology mesh(grid(6, 6));
  const IdealValence ideal(mesh);
  PatchGrowth patch(mesh, ideal);
  patch.clear();
  const Index v = vertex_at(mesh, {3, 3});
  for (int i = 0; i < 3; ++i) patch.add_face(mesh.faces_of(v)[i]);
  REQUIRE(patch.close(100));
  CHECK(patch.faces().size() == 4);
  PatchOutline outline;
  REQUIRE(patch.outline(outline));
  CHECK(outline.loop.size() == 8);
  CHECK(outline.corner == std::vector<Index>{0, 2, 4, 6});
  CHECK(outline.inside == std::vector<Index>{v});
  CHECK(outline.weight == 0);
}

TEST_CASE("a patch beyond the limit is hopeless") {
  const QuadTopology mesh(grid(6, 6));
  const IdealValence ideal(mesh);
  PatchGrowth patch(mesh, ideal);
  patch.clear();
  patch.add_star(vertex_at(mesh, {3, 3}));
  patch.add_ring();
  CHECK(!patch.close(15));
  patch.clear();
  CHECK(patch.faces().empty());
}

TEST_CASE("faces that are not one disk have no outline") {
  const QuadTopology mesh(grid(8, 8));
  const IdealValence ideal(mesh);
  PatchGrowth patch(mesh, ideal);
  PatchOutline outline;
  patch.clear();  // two pieces
  patch.add_star(vertex_at(mesh, {2, 2}));
  patch.add_star(vertex_at(mesh, {6, 6}));
  REQUIRE(patch.close(100));
  CHECK(!patch.outline(outline));
  patch.clear();  // a frame, which bends inwards all around its hole
  for (Index f = 0; f < mesh.face_slots(); ++f) {
    const Vec2 p = mesh.point(mesh.face(f)[0]);
    if (std::max(std::abs(p.x - 4), std::abs(p.y - 4)) > 2.5) patch.add_face(f);
  }
  REQUIRE(patch.close(100));
  REQUIRE(patch.outline(outline));  // the hole is filled: a disk
  CHECK(patch.faces().size() == 64);
  CHECK(outline.loop.size() == 32);
}

TEST_CASE("walls are not crossed") {
  // A wall of two edges from the left side to the middle: its end is fixed.
  QuadMesh start = grid(4, 4);
  const auto number = [&](Vec2 p) {
    return static_cast<Index>(std::find(start.points.begin(), start.points.end(), p) -
                              start.points.begin());
  };
  std::vector<Index> order;
  const std::vector<Vec2> on_wall{{1, 2}, {2, 2}};
  for (const Vec2 p : on_wall) {
    const Index v = number(p), first = start.fixed++;
    std::swap(start.points[v], start.points[first]);
    for (Face& face : start.faces)
      for (Index& w : face) w = w == v ? first : w == first ? v : w;
  }
  const auto wall = [&](Vec2 a, Vec2 b) {
    start.walls.push_back({std::min(number(a), number(b)), std::max(number(a), number(b))});
  };
  wall({0, 2}, {1, 2});
  wall({1, 2}, {2, 2});
  std::sort(start.walls.begin(), start.walls.end());
  const QuadTopology mesh(start);
  const IdealValence ideal(mesh);
  PatchGrowth patch(mesh, ideal);
  patch.clear();
  patch.add_ring();
  for (Index f = 0; f < mesh.face_slots(); ++f) patch.add_face(f);
  CHECK(!patch.close(100));
  patch.clear();  // below the wall: its vertices are on the rim
  for (Index f = 0; f < mesh.face_slots(); ++f)
    if (mesh.point(mesh.face(f)[0]).y < 2) patch.add_face(f);
  PatchOutline outline;
  REQUIRE(patch.close(100));
  REQUIRE(patch.outline(outline));
  CHECK(outline.loop.size() == 12);
}

//  +--+--+--+--+     a quad cut in two on either side of the middle: the four rows are a patch
//  where |  |  |\ |  |     pairs of triangles may be mended, and an end of the search where not
//  +--+--+--+--+
TEST_CASE("pairs of triangles are part of a patch where they may give way") {
  QuadMesh start = grid(6, 6);
  const auto cut = [&](Index f) {
    const Face quad = start.faces[f];
    start.faces[f] = {quad[0], quad[1], quad[2], none};
    start.faces.push_back({quad[0], quad[2], quad[3], none});
    start.region.push_back(0);
  };
  const QuadTopology uncut(start);
  const Index v = vertex_at(uncut, {3, 3});
  cut(uncut.faces_of(v)[0]);
  const QuadTopology mesh(start);
  const IdealValence ideal(mesh);
  for (const bool takes_triangles : {false, true}) {
    PatchGrowth patch(mesh, ideal, takes_triangles);
    patch.clear();
    patch.add_star(v);
    patch.add_ring();
    patch.add_ring();
    CHECK(patch.close(100) == takes_triangles);
    PatchOutline outline;
    CHECK(patch.outline(outline) == takes_triangles);
    if (!takes_triangles) continue;
    CHECK(patch.triangles() == 2);
    CHECK(outline.corner.size() == 4);
    CHECK(outline.weight > 0);
  }
}

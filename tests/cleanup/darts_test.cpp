// The last resort: seven quads for one that is not convex.
#include "cleanup/darts.h"

#include "base/rng.h"
#include "catch.h"
#include "cleanup/untangle.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

QuadMesh quad_of(const std::array<Vec2, 4>& corners) {
  QuadMesh mesh;
  mesh.points.assign(corners.begin(), corners.end());
  mesh.faces = {{0, 1, 2, 3}};
  mesh.region = {0};
  mesh.fixed = 4;
  return mesh;
}

QuadMesh cut(const QuadMesh& mesh, Index& count) {
  QuadTopology topology{QuadMesh(mesh)};
  count = cut_darts(topology);
  return std::move(topology).compact();
}

}  // namespace

TEST_CASE("every dart is cut into seven convex quads that cover it") {
  Rng rng(3);
  int darts = 0;
  for (int i = 0; i < 2000; ++i) {
    // The triangle D is inside of, its other corners turned at random: each corner is reflex once.
    const Vec2 a{0, 0}, b{rng.between(0.1, 1), rng.between(0, 1)};
    const Vec2 c{rng.between(-1, 0.1), rng.between(0.1, 1)};
    const double s = rng.between(0.02, 0.96), t = rng.between(0.01, 0.98 - s);
    const Vec2 d = a + s * (c - a) + t * (b - a);
    if (!(cross(b - a, c - a) > 0.01) || s + t > 0.99) continue;
    ++darts;
    std::array<Vec2, 4> corners{d, a, b, c};
    std::rotate(corners.begin(), corners.begin() + i % 4, corners.end());
    const QuadMesh before = quad_of(corners);
    REQUIRE(invalid_faces(before).size() == 1);
    Index count = 0;
    const QuadMesh after = cut(before, count);
    CHECK(count == 1);
    CHECK(after.faces.size() == 7);
    CHECK(invalid_faces(after).empty());
    CHECK(area_of(after) == Approx(area_of(before)));
    for (Index v = 0; v < 4; ++v) CHECK(after.points[v] == before.points[v]);
  }
  CHECK(darts > 500);
}

TEST_CASE("a straight corner is cut, a convex quad and a bow tie are left") {
  Index count = 0;
  CHECK(invalid_faces(cut(quad_of({{{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}}}), count)).empty());
  CHECK(count == 1);
  CHECK(cut(quad_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}), count).faces.size() == 1);
  CHECK(count == 0);
  CHECK(cut(quad_of({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), count).faces.size() == 1);
  CHECK(count == 0);
}

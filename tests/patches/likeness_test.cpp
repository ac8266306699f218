// A filling that only repeats its patch is known for what it is.
#include "patches/likeness.h"

#include <algorithm>

#include "catch.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

// All faces of a grid as a patch.
struct WholeGrid {
  explicit WholeGrid(Index n, Index m) : mesh(grid(n, m)), ideal(mesh), patch(mesh, ideal) {
    patch.clear();
    for (Index f = 0; f < mesh.face_slots(); ++f) patch.add_face(f);
    REQUIRE(patch.close(n * m));
    REQUIRE(patch.outline(outline));
  }

  std::vector<VertexRow> sides(Index turn = 0) const {
    const Index length = static_cast<Index>(outline.loop.size());
    std::vector<VertexRow> rows(4);
    for (Index k = 0; k < 4; ++k) {
      const Index next = k < 3 ? outline.corner[k + 1] : length;
      for (Index i = outline.corner[k]; i <= next; ++i) rows[k].push_back((i + turn) % length);
    }
    return rows;
  }

  Filling filling(Index turn = 0) const {
    Filling result;
    for (const Index v : outline.loop) result.points.push_back(mesh.point(v));
    fill_block(sides(turn), result);
    return result;
  }

  QuadTopology mesh;
  IdealValence ideal;
  PatchGrowth patch;
  PatchOutline outline;
};

}  // namespace

TEST_CASE("a grid filled as a grid is like before, in whatever order its faces are") {
  const WholeGrid whole(5, 3);
  Filling filling = whole.filling();
  CHECK(is_like_patch(filling, whole.outline, whole.mesh));
  std::reverse(filling.faces.begin(), filling.faces.end());
  for (Face& face : filling.faces) face = {face[2], face[3], face[0], face[1]};
  CHECK(is_like_patch(filling, whole.outline, whole.mesh));
}

//  +--+--+--+      +--+--+--+
//  |  |  |  |      |\ |  |  |     one edge turned: as many faces, other neighbours
//  +--+--+--+  ->  | \+--+--+
//  |  |  |  |      |  |\ |  |
TEST_CASE("as many faces with other neighbours are not like before") {
  const WholeGrid whole(4, 4);
  CHECK(!is_like_patch(whole.filling(1), whole.outline, whole.mesh));  // corners one vertex on
  Filling turned = whole.filling();
  // Two faces that share an edge (a, b): their outline a x b y .. with the edge one vertex on.
  const auto rows = turned.faces;
  for (std::size_t f = 1; f < rows.size(); ++f)
    for (int k = 0; k < 4; ++k) {
      const Index a = rows[0][k], b = rows[0][(k + 1) & 3], at = corner_of(rows[f], a);
      if (at == none || rows[f][(at + 3) & 3] != b) continue;
      const Index c = rows[0][(k + 2) & 3], d = rows[0][(k + 3) & 3];
      const Index e = rows[f][(at + 1) & 3], g = rows[f][(at + 2) & 3];
      turned.faces[0] = {b, c, d, g};
      turned.faces[f] = {d, a, e, g};
      CHECK(!is_like_patch(turned, whole.outline, whole.mesh));
      return;
    }
  FAIL("no neighbours");
}

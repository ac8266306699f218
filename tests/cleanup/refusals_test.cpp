// What was refused is known until something changes around it, and no longer.
#include "cleanup/refusals.h"

#include "catch.h"
#include "cleanup/cavities.h"
#include "cleanup/refill.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

Index vertex_at(const QuadTopology& mesh, Vec2 position) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.point(v) == position) return v;
  return none;
}

Cavity star(const QuadTopology& mesh, Index v) {
  const auto faces = mesh.faces_of(v);
  return {faces.begin(), faces.end()};
}

}  // namespace

TEST_CASE("a refusal holds until an edit reaches the faces at the cavity's corners") {
  QuadTopology mesh(grid(9, 4));
  const Cavity cavity = star(mesh, vertex_at(mesh, {2, 2}));
  Refusals refusals;
  CHECK(refusals.find(mesh, cavity) == nullptr);
  refusals.note(cavity, {{2, 2}});
  REQUIRE(refusals.find(mesh, cavity) != nullptr);
  CHECK(*refusals.find(mesh, cavity) == std::vector<Vec2>{{2, 2}});
  CHECK(refusals.find(mesh, star(mesh, vertex_at(mesh, {3, 2}))) == nullptr);

  // Its corners reach x = 3, and their faces x = 4.
  const Index far = vertex_at(mesh, {5, 2}), near = vertex_at(mesh, {4, 2});
  refusals.forget_around(mesh, std::vector<Index>{far});
  CHECK(refusals.find(mesh, cavity) != nullptr);
  refusals.forget_around(mesh, std::vector<Index>{near});
  CHECK(refusals.find(mesh, cavity) == nullptr);
  refusals.note(cavity, {});
  CHECK(refusals.find(mesh, cavity) != nullptr);
}

TEST_CASE("remembering what was refused changes no answer") {
  const QuadMesh start = scrambled(8, 8, 12, 3);
  const Fields fields = uniform_fields(start, 1);
  QuadTopology mesh(start), copy(start);
  const IdealValence ideal(mesh);
  DiskPatterns patterns;
  Refiller remembering(mesh, ideal, fields, patterns, {});
  Index edits = 0;
  for (int sweep = 0; sweep < 3; ++sweep)
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.valence(v) == 0) continue;
      const auto cavities = cavities_at(mesh, v, true);
      REQUIRE(cavities == cavities_at(copy, v, true));
      for (const Cavity& cavity : cavities) {
        Refiller forgetful(copy, ideal, fields, patterns, {});
        const bool accepted = forgetful.refill(cavity).accepted;
        CHECK(remembering.refill(cavity).accepted == accepted);
        if (!accepted) continue;
        ++edits;
        break;
      }
    }
  CHECK(edits > 1);
  CHECK(mesh.points() == copy.points());
}

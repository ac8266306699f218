// Rounds of smaller sizes, until the charts together have the topology of the surface.
#include "shell/rounds.h"

#include "catch.h"
#include "numerics/elementary.h"
#include "shell/check.h"
#include "shell/mesh_surface.h"

using namespace lpq;

namespace {

/// A tube with a thin wall along x, in needles from end to end.
void add_tube(Vec3 centre, double length, SurfaceSoup& soup) {
  const Index sides = 12, first = static_cast<Index>(soup.points.size());
  for (const double radius : {2.0, 2.7})
    for (const double x : {0.0, length})
      for (Index i = 0; i < sides; ++i) {
        const SinCos turn = sin_cos(2 * pi * i / sides);
        soup.points.push_back(centre + Vec3{x, radius * turn.cos, radius * turn.sin});
      }
  const auto add = [&](Index a, Index b, Index c, Index d) {
    soup.triangles.push_back({first + a, first + b, first + c});
    soup.triangles.push_back({first + a, first + c, first + d});
  };
  // Rings: inner near and far end, outer near and far end.
  const Index far = sides, outer = 2 * sides, outer_far = 3 * sides;
  for (Index i = 0; i < sides; ++i) {
    const Index j = (i + 1) % sides;
    add(i, j, far + j, far + i);
    add(outer + j, outer + i, outer_far + i, outer_far + j);
    add(j, i, outer + i, outer + j);
    add(far + i, far + j, outer_far + j, outer_far + i);
  }
}

SurfaceSoup bundle(Index tubes, double length) {
  SurfaceSoup soup;
  for (Index k = 0; k < tubes; ++k) add_tube({0, 10.0 * (k % 4), 10.0 * (k / 4)}, length, soup);
  return soup;
}

/// The steps up to the lifted charts.
Result<SurfaceMesher> mesh_charts(const SurfaceSoup& soup, double size) {
  auto mesher = SurfaceMesher::start(soup, {.size = size});
  while (mesher && mesher->stage() < SurfaceStage::seams)
    if (const auto stage = mesher->step(); !stage) return stage.error();
  return mesher;
}

}  // namespace

TEST_CASE("of many tubes that are thin for the size all get smaller quads at once", "[slow]") {
  const auto mesher = mesh_charts(bundle(16, 200), 8);
  REQUIRE(mesher.has_value());
  CHECK(check_shell(mesher->surface(), mesher->outcome().mesh).empty());
}

TEST_CASE("that a surface is narrow in too many places for the size is said, with a size") {
  const auto mesher = mesh_charts(bundle(1, 20'000), 60);
  REQUIRE(!mesher.has_value());
  CHECK(mesher.error().code == ErrorCode::no_valid_mesh);
  CHECK(mesher.error().message.find("narrow in many places") != std::string::npos);
  CHECK(mesher.error().message.find("Use a smaller size.") != std::string::npos);
}

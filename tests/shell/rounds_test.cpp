// Rounds of smaller sizes, until the charts together have the topology of the surface.
#include "shell/rounds.h"

#include <algorithm>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"
#include "shell/check.h"
#include "shell/mesh_surface.h"
#include "shell/place.h"
#include "shell/smaller.h"
#include "support/surface_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// A tube with a thin wall along x, in needles from end to end.
void add_tube(Vec3 centre, double length, double wall, SurfaceSoup& soup) {
  const Index sides = 12, first = static_cast<Index>(soup.points.size());
  for (const double radius : {2.0, 2 + wall})
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

SurfaceSoup bundle(Index tubes, double length, double wall = 0.7) {
  SurfaceSoup soup;
  for (Index k = 0; k < tubes; ++k)
    add_tube({0, 10.0 * (k % 4), 10.0 * (k / 4)}, length, wall, soup);
  return soup;
}

/// Every triangle as four.
SurfaceSoup refined(const SurfaceSoup& coarse) {
  SurfaceSoup soup;
  for (const auto& [a, b, c] : coarse.triangles) {
    const Vec3 p = coarse.points[a], q = coarse.points[b], r = coarse.points[c];
    const auto first = static_cast<Index>(soup.points.size());
    for (const Vec3 at : {p, q, r, midpoint(p, q), midpoint(q, r), midpoint(r, p)})
      soup.points.push_back(at);
    for (const Tri& t : {Tri{0, 3, 5}, Tri{3, 1, 4}, Tri{5, 4, 2}, Tri{3, 4, 5}})
      soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return soup;
}

/// Vertices of the surface that are on no feature and no border of a chart.
std::vector<Vec3> points_inside(const SurfaceMesher& mesher) {
  const SurfaceMesh& surface = mesher.surface();
  std::vector<char> on_line(surface.points.size(), 0);
  for (Index e = 0; e < static_cast<Index>(surface.twins.size()); ++e)
    if (mesher.atlas().cut[e] || mesher.features().half_edge_is_feature(e))
      on_line[surface.origin(e)] = on_line[surface.target(e)] = 1;
  std::vector<Vec3> inside;
  for (std::size_t v = 0; v < on_line.size(); ++v)
    if (!on_line[v]) inside.push_back(surface.points[v]);
  return inside;
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

TEST_CASE("sizes become smaller near the places of faults and nowhere else") {
  const SurfaceMesh sheet = plane_square(60);
  Rng rng(3);
  std::vector<double> size;
  for (std::size_t v = 0; v < sheet.points.size(); ++v) size.push_back(rng.between(0.02, 0.06));
  std::vector<Fault> faults;
  for (int k = 0; k < 40; ++k) {
    const double wa = rng.between(0, 0.5), wb = rng.between(0, 0.5);
    const SurfacePlace place{static_cast<Index>(rng.below(sheet.triangles.size())),
                             {wa, wb, 1 - wa - wb}};
    for (int times = 0; times < 2; ++times) faults.push_back({{}, place, {}});
  }
  std::vector<char> near(size.size(), 0);
  for (const Fault& fault : faults) {
    for (const Index v : sheet.triangles[fault.place.triangle]) near[v] = 1;
    const double radius = 1.5 * size_at(sheet.triangles, fault.place, size);
    for (std::size_t v = 0; v < near.size(); ++v)
      near[v] = near[v] || distance(sheet.points[v], point_at(sheet, fault.place)) < radius;
  }
  std::vector<double> now = size;
  const double any_growth = 1e9;
  REQUIRE(make_smaller(sheet, faults, false, any_growth, now));
  for (std::size_t v = 0; v < near.size(); ++v) CHECK((now[v] < size[v]) == (near[v] == 1));
}

TEST_CASE("where a chart of a fine surface fails nodes come on its lines only") {
  auto mesher = SurfaceMesher::start(refined(refined(bundle(1, 60, 0.02))), {.size = 3});
  REQUIRE(mesher.has_value());
  int rounds = 0;
  const ChartsMesher* before = nullptr;
  while (mesher->stage() < SurfaceStage::seams) {
    if (!mesher->step()) break;
    if (mesher->charts() == before) continue;
    before = mesher->charts();
    if (before == nullptr) continue;
    const std::vector<Vec3>& points = before->result().mesh.points;
    ++rounds;
    const std::vector<Vec3> inside = points_inside(*mesher);
    REQUIRE(!inside.empty());
    for (const Vec3 p : inside) REQUIRE(std::find(points.begin(), points.end(), p) == points.end());
  }
  CHECK(rounds > 2);  // in the third for the first time
}

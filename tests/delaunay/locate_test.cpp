// Point location against an exhaustive search, with any hint, in domains full of walls.
#include "delaunay/locate.h"

#include <limits>

#include "catch.h"
#include "support/delaunay_checks.h"

using namespace lpq_test;
using lpq::Locator;
using lpq::triangulate;

namespace {

Index exhaustive(const TriMesh& mesh, Vec2 p) {
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    if (lpq::contains(mesh, t, p)) return t;
  }
  return none;
}

double distance_to(const TriMesh& mesh, Index t, Vec2 p) {
  if (lpq::contains(mesh, t, p)) return 0;
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vec2 a = mesh.points[mesh.triangles[t][k]],
               b = mesh.points[mesh.triangles[t][(k + 1) % 3]];
    const double s = std::clamp(dot(p - a, b - a) / squared_length(b - a), 0.0, 1.0);
    best = std::min(best, distance(p, a + s * (b - a)));
  }
  return best;
}

TriMesh mesh_of(const BoundaryMesh& boundary, int inside) {
  auto mesh = triangulate(boundary, points_inside(boundary, inside, 1, 0.003));
  REQUIRE(mesh.has_value());
  return *std::move(mesh);
}

void check_location(const TriMesh& mesh, int queries, double reach, Vec2 centre = {0, 0}) {
  const Locator locator(mesh);
  lpq::Rng rng(2);
  Index hint = none;
  int wrong = 0, found = 0;
  for (int i = 0; i < queries; ++i) {
    const Vec2 p = centre + Vec2{rng.between(-reach, reach), rng.between(-reach, reach)};
    const bool inside = exhaustive(mesh, p) != none;
    found += inside;
    const Index any = static_cast<Index>(rng.below(mesh.triangles.size()));
    Index own_hint = i % 2 == 0 ? none : any;
    for (const Index t : {locate(mesh, p, any), locate(mesh, p, none), locator.find(p, hint),
                          locator.find(p, own_hint)}) {
      wrong += (t != none) != inside || (inside && !lpq::contains(mesh, t, p));
    }
    const Index nearest = locator.find_nearest(p, own_hint);
    if (inside) wrong += nearest == none || !lpq::contains(mesh, nearest, p);
    if (inside || i % 10 != 0) continue;
    double best = std::numeric_limits<double>::infinity();
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      best = std::min(best, distance_to(mesh, t, p));
    wrong += nearest == none || distance_to(mesh, nearest, p) > best * (1 + 1e-12);
    wrong += own_hint != nearest;
  }
  CHECK(wrong == 0);
  CHECK(found > 0);
}

}  // namespace

TEST_CASE("location in nonconvex domains with holes") {
  check_location(mesh_of(flower_with_holes(), 1000), 2000, 1.5);
  check_location(mesh_of(flower_with_holes(), 0), 1000, 1.5);
}

TEST_CASE("location in a spiral, where straight walks are blocked") {
  check_location(mesh_of(spiral(1000), 500), 1000, 1.2);
}

TEST_CASE("location across interior walls") {
  BoundaryMesh boundary = boundary_of({rectangle({-1, -1}, {1, 1})});
  for (int i = 0; i < 20; ++i)
    add_polyline(boundary, {{-0.9, i / 11.0 - 0.9}, {0.95, i / 11.0 - 0.9}});
  check_location(mesh_of(boundary, 500), 1000, 1.1);
}

TEST_CASE("vertices, edges and the rim belong to the mesh") {
  const TriMesh mesh = mesh_of(flower_with_holes(), 200);
  const Locator locator(mesh);
  Index hint = none;
  for (const Vec2 p : mesh.points) {
    const Index t = locator.find(p, hint);
    REQUIRE(t != none);
    CHECK(lpq::contains(mesh, t, p));
    CHECK(locate(mesh, p, 0) != none);
  }
  // Midpoints of walls may fall outside by rounding: the nearest triangle is the wall's own.
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    if (mesh.twins[e] != none) continue;
    const Vec2 p = midpoint(mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]);
    hint = none;
    const Index t = locator.find_nearest(p, hint);
    REQUIRE(t != none);
    CHECK(distance_to(mesh, t, p) < 1e-15);
  }
}

TEST_CASE("thin triangles make a coarse grid, not a huge one") {
  Loop circle = star_curve({0, 0}, 20000, [](double) { return 1.0; });
  const TriMesh mesh = mesh_of(boundary_of({circle}), 0);
  check_location(mesh, 100, 1.1);
  Loop strip;
  for (int i = 0; i < 500; ++i) strip.push_back({i * 1.0, 0});
  for (int i = 0; i < 500; ++i) strip.push_back({499.0 - i, 1e-3});
  check_location(mesh_of(boundary_of({strip}), 0), 500, 5e-3, {250, 0});
}

TEST_CASE("an empty locator finds nothing") {
  const TriMesh empty;
  const Locator locator(empty);
  Index hint = none;
  CHECK(locator.find({0, 0}, hint) == none);
  CHECK(locator.find_nearest({0, 0}, hint) == none);
  CHECK(locate(empty, {0, 0}, none) == none);
}

// The clipped diagram on small domains with every kind of wall: tiling, symbolic vertices, nearest
// sites, and the cells as polygons.
#include "support/voronoi_checks.h"

namespace lpq {
namespace {

using namespace lpq_test;
using namespace lpq::test;

BoundaryMesh unit_square(double h) {
  return boundary_of({divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, h)});
}

std::vector<BoundaryMesh> boundaries() {
  std::vector<BoundaryMesh> all;
  all.push_back(unit_square(0.25));
  all.push_back(unit_square(2));  // long walls: many cells meet each
  all.push_back(boundary_of({{{0, 0}, {1, 0}, {1, 0.01}, {0, 0.012}}}));
  all.push_back(boundary_of({{{0, 0}, {1, 0.02}, {0.9, 0.08}}}));
  all.push_back(boundary_of({{{0, 0}, {1, 0}, {0.5, 0.1}, {1, 1}, {0, 1}, {0.4, 0.3}}}));
  all.push_back(boundary_of({
      divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.3),
      reversed(circle({0.5, 0.5}, 0.4, 7)),
  }));
  BoundaryMesh walled = unit_square(0.5);
  add_wall(walled, std::vector<Vec2>{{0.1, 0.5}, {0.9, 0.52}, {0.9, 0.1}});
  add_wall(walled, std::vector<Vec2>{{0.2, 0.53}, {0.7, 0.56}});
  all.push_back(std::move(walled));
  return all;
}

double polygon_area(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return 0.5 * twice;
}

}  // namespace

TEST_CASE("cells tile domains with corners, holes, channels and interior walls") {
  for (const BoundaryMesh& boundary : boundaries())
    for (const int count : {0, 1, 2, 5, 40, 400})
      for (const int hug : {1, 8}) {
        const TriMesh mesh = triangulated(boundary, scattered(boundary, count, 17, hug));
        ClippedVoronoi voronoi;
        clip_voronoi(mesh, voronoi);
        const double area = mesh_area(mesh);
        const AreaReport report = fan_areas(mesh, voronoi);
        CHECK(std::abs(report.sum - area) <= 1e-12 * area);
        CHECK(report.negative >= -1e-12 * area);
        CHECK(equidistance_error(mesh, voronoi) < 1e-13);
      }
}

TEST_CASE("polygons have the areas of their fans and their vertices lie in the domain") {
  for (const BoundaryMesh& boundary : boundaries()) {
    const TriMesh mesh = triangulated(boundary, scattered(boundary, 60, 23));
    ClippedVoronoi voronoi;
    clip_voronoi(mesh, voronoi);
    const auto polygons = cell_polygons(mesh, voronoi);
    REQUIRE(polygons.size() == mesh.points.size());
    const Locator locator(mesh);
    double sum = 0;
    for (const auto& pieces : polygons)
      for (const auto& polygon : pieces) {
        CHECK(polygon.size() >= 3);
        sum += polygon_area(polygon);
        for (const Vec2 p : polygon) {
          Index hint = none;
          const Index t = locator.find_nearest(p, hint);
          REQUIRE(t != none);
          const Tri& tri = mesh.triangles[t];
          for (int k = 0; k < 3; ++k) {
            const Vec2 a = mesh.points[tri[k]], b = mesh.points[tri[(k + 1) % 3]];
            CHECK(cross(b - a, p - a) >= -1e-12);
          }
        }
      }
    CHECK(std::abs(sum - mesh_area(mesh)) < 1e-12);
  }
}

TEST_CASE("in a convex domain every point lies in the cell of its nearest site") {
  const BoundaryMesh boundary = boundary_of({{{0, 0}, {1, 0}, {1.2, 0.4}, {0.6, 0.9}, {0, 0.5}}});
  const TriMesh mesh = triangulated(boundary, scattered(boundary, 80, 2, 3));
  ClippedVoronoi voronoi;
  clip_voronoi(mesh, voronoi);
  // The centroid of every fan triangle is nearest to the fan's own site.
  for (const FanTriangle& fan : voronoi.cells.values) {
    const Vec2 site = mesh.points[fan.site];
    const Vec2 y =
        (1.0 / 3) * (site + voronoi.vertices[fan.c1].point + voronoi.vertices[fan.c2].point);
    for (const Vec2 other : mesh.points) CHECK(distance(y, site) <= distance(y, other) + 1e-13);
  }
}

TEST_CASE("symbolic vertices: kinds, generators, walls") {
  for (const BoundaryMesh& boundary : boundaries()) {
    const TriMesh mesh = triangulated(boundary, scattered(boundary, 50, 31, 4));
    ClippedVoronoi voronoi;
    clip_voronoi(mesh, voronoi);
    for (const VoronoiVertex& vertex : voronoi.vertices) {
      CHECK(vertex.sites[0] != none);
      CHECK(vertex.sites[1] != none);
      CHECK(vertex.sites[0] != vertex.sites[1]);
      if (vertex.kind == VertexKind::three_bisectors) {
        CHECK(vertex.sites[2] != none);
        CHECK(vertex.wall == none);
        continue;
      }
      REQUIRE(vertex.wall != none);
      CHECK(mesh.twins[vertex.wall] == none);
      const Vec2 a = mesh.points[mesh.origin(vertex.wall)],
                 b = mesh.points[mesh.target(vertex.wall)];
      CHECK(std::abs(cross(b - a, vertex.point - a)) <= 1e-15);
      CHECK(dot(b - a, vertex.point - a) >= 0);
      CHECK(dot(a - b, vertex.point - b) >= 0);
    }
  }
}

TEST_CASE("scaling by a power of two scales every vertex exactly") {
  for (const BoundaryMesh& boundary : boundaries()) {
    const auto points = scattered(boundary, 50, 7);
    auto scaled_points = points;
    for (Vec2& p : scaled_points) p = 0x1p-9 * p;
    ClippedVoronoi voronoi, small;
    clip_voronoi(triangulated(boundary, points), voronoi);
    clip_voronoi(triangulated(scaled(boundary, 0x1p-9), scaled_points), small);
    REQUIRE(voronoi.vertices.size() == small.vertices.size());
    for (std::size_t i = 0; i < voronoi.vertices.size(); ++i)
      CHECK(0x1p-9 * voronoi.vertices[i].point == small.vertices[i].point);
  }
}

// Found with circumcentres taken relative to an arbitrary corner: where two nodes almost coincide
// the numerators cancel and cells of a domain 10^-12 thick turned over.
TEST_CASE("a domain as thin as rounding is still tiled") {
  const Vec2 origin{-0.42592591, -0.216049403969};
  std::vector<Vec2> loop{{-0.413580239, -0.2160494039697}, {-0.401234567, -0.2160494039716},
                         {-0.401234567, -0.2160494039715}, {-0.401234567, -0.2160494039713},
                         {-0.413580239, -0.2160494039694}, {-0.42592591, -0.216049403969},
                         {-0.413580239, -0.2160494039696}};
  for (Vec2& p : loop) p -= origin;
  const BoundaryMesh boundary = boundary_of({loop});
  const TriMesh mesh = triangulated(boundary, {});
  ClippedVoronoi voronoi;
  clip_voronoi(mesh, voronoi);
  const double area = mesh_area(mesh);
  const AreaReport report = fan_areas(mesh, voronoi);
  CHECK(std::abs(report.sum - area) <= 1e-12 * area);
  CHECK(report.negative >= -1e-12 * area);
}

TEST_CASE("circumcentres of needles keep their digits") {
  const Vec2 a{0.3, 0.7}, b{0.3, 0.7 + 0x1p-50}, c{0.9, 0.1};
  for (const Vec2 centre : {circumcentre(a, c, b), circumcentre(c, b, a), circumcentre(b, a, c)}) {
    CHECK(std::abs(distance(centre, a) - distance(centre, c)) < 1e-15);
    CHECK(std::abs(centre.y - a.y) < 1e-15);
  }
}

}  // namespace lpq

// Single guarded edits and the sweeps made of them, each with its picture.
#include "cleanup/refill.h"

#include "catch.h"
#include "cleanup/cavities.h"
#include "cleanup/topology.h"
#include "cleanup/untangle.h"
#include "mesh/quality.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

struct Edited {
  QuadMesh mesh;
  TopologyStats stats;
  double irregularity = 0;
};

Edited regularised(const QuadMesh& start) {
  const Fields fields = uniform_fields(start, 1);
  QuadTopology topology(start);
  const IdealValence ideal(topology);
  Edited result;
  DiskPatterns patterns;
  result.stats = regularise(topology, ideal, fields, patterns);
  result.irregularity = ideal.total_weight(topology);
  result.mesh = std::move(topology).compact();
  return result;
}

void check_sound(const Edited& edited, const QuadMesh& start) {
  CHECK(border_of(edited.mesh) == border_of(start));
  CHECK(area_of(edited.mesh) == Approx(area_of(start)));
  CHECK(edited.mesh.fixed == start.fixed);
  for (Index v = 0; v < start.fixed; ++v) CHECK(edited.mesh.points[v] == start.points[v]);
  CHECK(edited.mesh.region.size() == edited.mesh.faces.size());
}

}  // namespace

TEST_CASE("a regular mesh is left alone") {
  const QuadMesh start = grid(6, 5);
  const Edited edited = regularised(start);
  CHECK(edited.mesh.faces == start.faces);
  CHECK(edited.irregularity == 0);
}

//  +--+--+--+     +--+--+--+
//  |  |\ |  |     |  |  |  |
//  +--+ \+--+     +--+--+--+
//  |  +\ |  |  -> |  |  |  |    one turned edge: two 3-valent and two 5-valent vertices
//  +--+ \+--+     +--+--+--+
TEST_CASE("a turned edge is turned back") {
  const QuadMesh start = scrambled(6, 6, 1, 3);
  const Edited edited = regularised(start);
  check_sound(edited, start);
  CHECK(edited.irregularity == 0);
  CHECK(edited.mesh.faces.size() == start.faces.size());
  CHECK(edited.stats.rotations == 1);
  CHECK(invalid_faces(edited.mesh).empty());
}

//  +-----+     +-----+
//  | \ / |     |     |
//  |  x--+  -> |     |     a vertex of valence 3 in a hexagon: fewer faces
//  | / \ |     |     |
//  +-----+     +-----+
TEST_CASE("an inserted diamond is collapsed") {
  // The middle vertex of a grid opened into a quad: the inverse of the collapse.
  QuadMesh start = grid(6, 6);
  Index v = none;
  for (Index w = start.fixed; w < static_cast<Index>(start.points.size()); ++w)
    if (start.points[w] == Vec2{3, 3}) v = w;
  const Index twin = static_cast<Index>(start.points.size());
  start.points.push_back({3, 3.3});
  start.points[v] = {3, 2.7};
  Index left = none, right = none;
  for (Index w = 0; w < twin; ++w) {
    if (start.points[w] == Vec2{2, 3}) left = w;
    if (start.points[w] == Vec2{4, 3}) right = w;
  }
  for (Face& face : start.faces)
    if (corner_of(face, v) != none && start.points[face[2]].y > 3.1)
      face[corner_of(face, v)] = twin;
  start.faces.push_back({v, right, twin, left});
  start.region.push_back(0);
  const Edited edited = regularised(start);
  check_sound(edited, start);
  CHECK(edited.irregularity == 0);
  CHECK(edited.mesh.faces.size() == 36);
  CHECK(edited.stats.diamonds >= 1);
}

//   +---+---+       +---+---+
//   | \   / |       |   |   |
//   |   x   |   ->  | +---+ |     the middle wall vertex has one quad over 180 degrees, which
//   | /   \ |       | |   | |     no smoothing can make convex
//   a---v---b       a---v---b
TEST_CASE("a straight boundary angle gets its second quad") {
  QuadMesh start = grid(6, 4);
  // Merge the two quads above the wall vertex (3, 0) with their top neighbours' edges.
  const auto at = [&](double x, double y) {
    for (Index w = 0; w < static_cast<Index>(start.points.size()); ++w)
      if (start.points[w] == Vec2{x, y}) return w;
    return none;
  };
  const Index a = at(2, 0), v = at(3, 0), b = at(4, 0), p = at(2, 1), q = at(3, 1), r = at(4, 1);
  std::vector<Face> faces;
  for (const Face& face : start.faces)
    if (corner_of(face, v) == none) faces.push_back(face);
  faces.push_back({a, v, b, q});
  faces.push_back({a, q, p, none});
  faces.push_back({b, r, q, none});
  // Two triangles are left; pair each with the quad above it by a vertex inside would be another
  // story, so this mesh is quad-dominant and the repair must work beside them.
  start.faces = faces;
  start.region.assign(faces.size(), 0);
  REQUIRE(invalid_faces(start).size() == 1);
  const Fields fields = uniform_fields(start, 1);
  QuadTopology topology(start);
  const IdealValence ideal(topology);
  DiskPatterns patterns(PatternSet::repair);
  repair_invalid(topology, ideal, fields, patterns);
  const QuadMesh result = std::move(topology).compact();
  CHECK(invalid_faces(result).empty());
  CHECK(border_of(result) == border_of(start));
  int triangles = 0;
  for (const Face& face : result.faces) triangles += face[3] == none;
  CHECK(triangles == 2);
}

//   e---d---c       e---d---c
//   |   |   |       |   |   |
//   |   x   |   ->  |   |   |     valid, but the quad at v has a corner of nearly 180 degrees
//   | /   \ |       |   |   |
//   a---v---b       a---v---b
TEST_CASE("a flat quad at a wall is mended") {
  const QuadMesh start = mesh_of({{0, 0}, {2, -0.01}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {2, 2}},
                                 {{0, 1, 2, 6}, {2, 3, 4, 6}, {6, 4, 5, 0}}, 6);
  REQUIRE(invalid_faces(start).empty());
  REQUIRE(face_eta(start.points, start.faces[0]) < 0.01);
  QuadTopology topology(start);
  const IdealValence ideal(topology);
  DiskPatterns patterns(PatternSet::repair);
  mend_flat(topology, ideal, uniform_fields(start, 2), patterns);
  const QuadMesh result = std::move(topology).compact();
  CHECK(border_of(result) == border_of(start));
  CHECK(invalid_faces(result).empty());
  for (const Face& face : result.faces) CHECK(face_eta(result.points, face) > 0.4);
}

TEST_CASE("mending flat quads leaves needles and good meshes alone") {
  const QuadMesh needle = mesh_of({{0, 0}, {9, -0.1}, {10, 0}, {9, 0.1}}, {{0, 1, 2, 3}}, 4);
  for (const QuadMesh& start : {needle, grid(5, 4), shaken(grid(5, 4), 0.2)}) {
    QuadTopology topology(start);
    const IdealValence ideal(topology);
    DiskPatterns patterns(PatternSet::repair);
    mend_flat(topology, ideal, uniform_fields(start, 1), patterns);
    CHECK(std::move(topology).compact().faces == start.faces);
  }
}

TEST_CASE("one quad with a reflex corner becomes five convex ones") {
  const QuadMesh start = mesh_of({{0, 0}, {4, -1}, {1, 1}, {-1, 4}}, {{0, 1, 2, 3}}, 4);
  REQUIRE(invalid_faces(start).size() == 1);
  QuadTopology topology(start);
  const IdealValence ideal(topology);
  DiskPatterns patterns(PatternSet::repair);
  repair_invalid(topology, ideal, uniform_fields(start, 1), patterns);
  const QuadMesh result = std::move(topology).compact();
  CHECK(result.faces.size() == 5);
  CHECK(invalid_faces(result).empty());
  CHECK(border_of(result) == border_of(start));
}

TEST_CASE("scrambled grids: irregularity only falls, nothing else breaks") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    QuadMesh start = scrambled(12, 10, 15, seed);
    untangle(start);
    const QuadTopology before(start);
    const IdealValence ideal(before);
    double irregularity = 0;
    for (Index v = 0; v < before.vertex_count(); ++v) irregularity += ideal.weight(before, v);
    const Edited edited = regularised(start);
    check_sound(edited, start);
    CHECK(edited.irregularity <= 0.5 * irregularity);
    CHECK(invalid_faces(edited.mesh).size() <= invalid_faces(start).size());
  }
}

TEST_CASE("walls are never crossed") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    // Two grids glued along a fixed wall: the vertices of column 6 become fixed.
    QuadMesh mesh = scrambled(12, 8, 20, seed);
    const Index fixed = mesh.fixed;
    std::vector<Index> column;
    for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v)
      if (mesh.points[v].x == 6) column.push_back(v);
    for (Index& v : column) {
      if (v < fixed) continue;
      const Index w = mesh.fixed++;
      std::swap(mesh.points[v], mesh.points[w]);
      for (Face& face : mesh.faces)
        for (Index& c : face) c = c == v ? w : c == w ? v : c;
      v = w;
    }
    std::sort(column.begin(), column.end(),
              [&](Index a, Index b) { return mesh.points[a].y < mesh.points[b].y; });
    const QuadTopology probe(mesh);
    for (std::size_t i = 0; i + 1 < column.size(); ++i) {
      const Index a = std::min(column[i], column[i + 1]), b = std::max(column[i], column[i + 1]);
      if (probe.face_with_edge(a, b) != none && probe.face_with_edge(b, a) != none)
        mesh.walls.push_back({a, b});
    }
    std::sort(mesh.walls.begin(), mesh.walls.end());
    const Edited edited = regularised(mesh);
    check_sound(edited, mesh);
    const QuadTopology after(edited.mesh);
    for (const auto& wall : mesh.walls) {
      CHECK(after.face_with_edge(wall[0], wall[1]) != none);
      CHECK(after.face_with_edge(wall[1], wall[0]) != none);
    }
  }
}

TEST_CASE("cavities with triangles or fixed vertices inside are refused") {
  QuadMesh mesh = grid(4, 4);
  mesh.fixed = static_cast<Index>(mesh.points.size());
  const Fields fields = uniform_fields(mesh, 1);
  QuadTopology topology(mesh);
  const IdealValence ideal(topology);
  DiskPatterns patterns;
  Refiller refiller(topology, ideal, fields, patterns, {});
  const auto star = topology.faces_of(20);
  REQUIRE(star.size() == 4);
  CHECK(!refiller.refill(Cavity(star.begin(), star.end())).accepted);
}

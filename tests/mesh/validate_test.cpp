#include "mesh/validate.h"

#include "catch.h"
#include "support/mesh_checks.h"
#include "support/tiny_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

bool mentions(const std::vector<Violation>& violations, const std::string& words) {
  return std::any_of(violations.begin(), violations.end(), [&](const Violation& violation) {
    return violation.what.find(words) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("a grid is valid") {
  for (auto [nx, ny] : {std::array{1, 1}, {1, 5}, {4, 3}, {30, 20}}) {
    const QuadMesh mesh = grid_quads(nx, ny);
    const DirectedEdges boundary = outer_boundary(mesh);
    CHECK(boundary.size() == static_cast<std::size_t>(2 * (nx + ny)));
    CHECK(sentences(validate(mesh, {boundary, mesh.points})) == "");
    CHECK(sentences(topology_faults(mesh, {boundary})) == "");
  }
}

TEST_CASE("signs are exact, and judged at the coordinates given") {
  QuadMesh mesh = grid_quads(4, 4);
  const DirectedEdges boundary = outer_boundary(mesh);
  const Index inner = mesh.fixed;  // of the quad at the corner (0, 0), opposite the corner
  REQUIRE(mesh.points[inner] == Vec2{0.25, 0.25});
  mesh.points[inner] = {0x1p-60, 0.25};
  CHECK(validate(mesh, {boundary}).empty());
  mesh.points[inner] = {0, 0.25};  // exactly on the boundary
  const auto flat = validate(mesh, {boundary});
  CHECK(mentions(flat, "not strictly convex"));
  CHECK(mentions(flat, "coincide"));
  mesh.points[inner] = {-0x1p-60, 0.25};
  CHECK(mentions(validate(mesh, {boundary}), "not strictly convex"));
  CHECK(topology_faults(mesh, {boundary}).empty());
}

TEST_CASE("a violation says where") {
  QuadMesh mesh = grid_quads(4, 4);
  const DirectedEdges boundary = outer_boundary(mesh);
  mesh.points[mesh.fixed] = {0.9, 0.9};
  const auto found = validate(mesh, {boundary});
  REQUIRE(!found.empty());
  CHECK(found[0].face != none);
  CHECK(found[0].vertex != none);
  CHECK(found[0].point == mesh.points[found[0].vertex]);
  CHECK(validate(mesh, {boundary}, 1).size() == 1);
}

TEST_CASE("numbers that later checks rely on") {
  const QuadMesh good = grid_quads(2, 2);
  const DirectedEdges boundary = outer_boundary(good);
  QuadMesh mesh = good;
  mesh.faces[1][2] = 99;
  CHECK(mentions(validate(mesh, {boundary}), "names a vertex that is not there"));
  mesh = good;
  mesh.faces[1][0] = none;
  CHECK(mentions(validate(mesh, {boundary}), "names a vertex that is not there"));
  mesh = good;
  mesh.points[3].y = std::nan("");
  CHECK(mentions(validate(mesh, {boundary}), "not finite"));
  mesh = good;
  mesh.region.pop_back();
  CHECK(mentions(validate(mesh, {boundary}), "regions"));
  CHECK(mentions(validate(QuadMesh{}, {boundary}), "no faces"));
}

TEST_CASE("moved boundary points are found bit by bit") {
  QuadMesh mesh = grid_quads(2, 2);
  const std::vector<Vec2> given(mesh.points.begin(), mesh.points.begin() + mesh.fixed);
  const DirectedEdges boundary = outer_boundary(mesh);
  CHECK(validate(mesh, {boundary, given}).empty());
  mesh.points[2].x = std::nextafter(mesh.points[2].x, 0);
  CHECK(mentions(validate(mesh, {boundary, given}), "Boundary vertex 2 has moved"));
}

TEST_CASE("conformity") {
  const QuadMesh good = grid_quads(3, 3);
  const DirectedEdges boundary = outer_boundary(good);
  SECTION("a missing face") {
    QuadMesh mesh = good;
    mesh.faces.pop_back();
    mesh.region.pop_back();
    const auto found = validate(mesh, {boundary});
    CHECK(mentions(found, "belongs to no face"));
    CHECK(mentions(found, "missing from the mesh"));
    CHECK(mentions(found, "not on the boundary"));
  }
  SECTION("a face twice") {
    QuadMesh mesh = good;
    mesh.faces.push_back(mesh.faces[4]);
    mesh.region.push_back(0);
    CHECK(mentions(validate(mesh, {boundary}), "used twice in the same direction"));
  }
  SECTION("a face turned over") {
    QuadMesh mesh = good;
    std::swap(mesh.faces[4][1], mesh.faces[4][3]);
    CHECK(mentions(topology_faults(mesh, {boundary}), "used twice in the same direction"));
  }
  SECTION("a crack: one inner vertex doubled in one face") {
    QuadMesh mesh = good;
    for (Index& v : mesh.faces[4])
      if (v == mesh.fixed) v = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(mesh.points[mesh.fixed]);
    const auto found = validate(mesh, {boundary});
    CHECK(mentions(found, "coincide"));
    CHECK(mentions(found, "not on the boundary"));
  }
  SECTION("an unused vertex") {
    QuadMesh mesh = good;
    mesh.points.push_back({0.4, 0.4});
    CHECK(mentions(validate(mesh, {boundary}), "belongs to no face"));
  }
  SECTION("an expected edge inside the mesh") {
    DirectedEdges more = boundary;
    more.push_back({good.faces[4][0], good.faces[4][1]});
    CHECK(mentions(validate(good, {more}), "has faces on both sides"));
  }
  SECTION("an expected edge twice") {
    DirectedEdges more = boundary;
    more.push_back(boundary[0]);
    CHECK(mentions(validate(good, {more}), "listed twice"));
  }
}

TEST_CASE("walls are inner edges") {
  QuadMesh mesh = grid_quads(3, 3);
  const DirectedEdges boundary = outer_boundary(mesh);
  const auto wall = [&](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  mesh.walls = {wall(mesh.faces[4][0], mesh.faces[4][1])};
  CHECK(validate(mesh, {boundary}).empty());
  mesh.walls = {wall(mesh.faces[4][0], mesh.faces[4][2])};
  CHECK(mentions(validate(mesh, {boundary}), "is not an inner edge"));
  mesh.walls = {wall(boundary[0][0], boundary[0][1])};
  CHECK(mentions(validate(mesh, {boundary}), "is not an inner edge"));
  mesh.walls = {{3, 3}};
  CHECK(mentions(validate(mesh, {boundary}), "rising order"));
}

TEST_CASE("two squares that touch in a point: two fans where two boundary edges leave") {
  //         5---6
  //         |   |
  //     3---2---4         The same mesh is wrong when only one fan is expected.
  //     |   |
  //     0---1
  QuadMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {1, 2}, {2, 2}};
  mesh.faces = {{0, 1, 2, 3}, {2, 4, 6, 5}};
  mesh.region = {0, 1};
  mesh.fixed = 7;
  const DirectedEdges boundary = outer_boundary(mesh);
  CHECK(sentences(validate(mesh, {boundary})) == "");
  const DirectedEdges part(boundary.begin(), boundary.end() - 2);
  CHECK(!validate(mesh, {part}).empty());
}

TEST_CASE("a vertex whose faces form a closed fan and a second one") {
  // The centre of a 2 x 2 grid is also the corner of another square lying on top.
  QuadMesh mesh = grid_quads(2, 2);
  const auto n = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{3, 0.5}, {3, 3}, {0.5, 3}});
  mesh.faces.push_back({8, n, n + 1, n + 2});
  mesh.region.push_back(0);
  DirectedEdges boundary = outer_boundary(mesh);
  CHECK(mentions(validate(mesh, {boundary}), "do not form one fan"));
}

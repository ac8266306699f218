// How faces hang together, counted on surfaces whose topology is known, and what is wrong with
// faces.
#include "shell/topology.h"

#include <algorithm>

#include "catch.h"
#include "shell/mesh_charts.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

namespace {

ShellTopology topology_of(const SurfaceMesh& mesh) {
  return shell_topology(faces_of(mesh.triangles));
}

/// n x n quads over the unit square.
struct Grid {
  std::vector<Vec3> points;
  std::vector<Face> faces;
  explicit Grid(Index n) {
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i) points.push_back({double(i), double(j), 0});
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) {
        const Index a = j * (n + 1) + i;
        faces.push_back({a, a + 1, a + n + 2, a + n + 1});
      }
  }
  std::string only_violation() const {
    const std::vector<Violation> found = validate_faces(points, faces);
    REQUIRE(found.size() == 1);
    return found[0].what;
  }
};

}  // namespace

TEST_CASE("parts, borders and Euler numbers of known surfaces") {
  const ShellTopology ball = topology_of(sphere(6)), ring = topology_of(torus(16, 8, 1, 0.4)),
                      pipe = topology_of(cylinder(12, 3, 1, 1)),
                      sheet = topology_of(plane_square(3));
  CHECK((ball.components == 1 && ball.borders == 0 && ball.euler == 2));
  CHECK((ring.components == 1 && ring.borders == 0 && ring.euler == 0));
  CHECK((pipe.components == 1 && pipe.borders == 2 && pipe.euler == 0));
  CHECK((sheet.components == 1 && sheet.borders == 1 && sheet.euler == 1));
  CHECK(sheet.border_edges == 12);
  for (const ShellTopology& one : {ball, ring, pipe, sheet})
    CHECK(one.meeting_edges + one.one_sided_edges + one.pinches == 0);
}

TEST_CASE("a Moebius band has one border and edges with two sides that differ") {
  const auto band = repair_surface(band_soup(12, 1));
  REQUIRE(band.has_value());
  const ShellTopology topology = topology_of(band->mesh);
  CHECK(topology.euler == 0);
  CHECK(topology.borders == 1);
  CHECK(topology.one_sided_edges > 0);
}

TEST_CASE("sheets that meet in an edge, and parts that meet in a point") {
  Grid grid(2);
  grid.points.push_back({1, 0, 1});
  grid.points.push_back({1, 1, 1});
  grid.faces.push_back({1, 4, 10, 9});  // stands on an inner edge
  ShellTopology topology = shell_topology(grid.faces);
  CHECK(topology.meeting_edges == 1);
  CHECK(topology.components == 1);
  CHECK(topology.pinches == 0);
  Grid pinched(2);
  pinched.faces = {pinched.faces[0], pinched.faces[3]};  // corner to corner
  topology = shell_topology(pinched.faces);
  CHECK(topology.components == 2);
  CHECK(topology.pinches == 1);
  CHECK(topology.borders == 1);
}

TEST_CASE("what is wrong with a face is said") {
  CHECK(validate_faces(Grid(3).points, Grid(3).faces).empty());
  Grid twice(3);
  twice.faces.push_back(
      {twice.faces[4][2], twice.faces[4][1], twice.faces[4][0], twice.faces[4][3]});
  CHECK(twice.only_violation() == "Two faces have the same vertices.");
  Grid bent(3);
  bent.points[5] = {2.1, 2.1, 0};  // an inner point beyond its neighbour
  const std::vector<Violation> found = validate_faces(bent.points, bent.faces);
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].what == "A quad is not convex.");
  Grid crack(1);
  crack.points.push_back(crack.points[1]);
  crack.points.push_back({2, 0, 0});
  crack.points.push_back({2, 1, 0});
  crack.faces.push_back({4, 5, 6, 3});
  CHECK(crack.only_violation() == "Two vertices lie in the same place.");
  Grid torn(1);
  torn.faces[0][2] = torn.faces[0][1];
  CHECK(torn.only_violation() == "A face has a vertex twice.");
}

TEST_CASE("violations are listed up to a limit") {
  Grid grid(4);
  const std::vector<Face> again = grid.faces;
  grid.faces.insert(grid.faces.end(), again.begin(), again.end());
  CHECK(validate_faces(grid.points, grid.faces, 3).size() == 3);
}

TEST_CASE("errors of charts speak of the surface, not of loops in the plane") {
  Error crossing{ErrorCode::self_intersection, "Edge 3 of loop 0 crosses edge 7 of loop 0.", {}};
  crossing.where.loop = 0;
  Error bent{ErrorCode::no_valid_mesh, "Face 0 is not strictly convex at vertex 287.", {}};
  bent.where.has_point = true;
  for (const Error& error : {crossing, bent}) {
    const std::string words = chart_words(error);
    for (const char* plane : {"loop", "vertex", "boundary", "0"})
      CHECK(words.find(plane) == std::string::npos);
    CHECK(words.find("smaller size") != std::string::npos);
  }
  // No option of domains, and no number of the plane.
  for (const ErrorCode code : {ErrorCode::odd_boundary, ErrorCode::lost_precision,
                               ErrorCode::bad_size, ErrorCode::touching, ErrorCode::zero_area,
                               ErrorCode::too_few_points, ErrorCode::no_valid_mesh}) {
    const std::string words =
        chart_words({code, "The domain has 237 boundary edges (--allow-added-point).", {}});
    for (const char* plane : {"--", "domain", "boundary", "237"})
      CHECK(words.find(plane) == std::string::npos);
    CHECK(words.find(" size") != std::string::npos);
  }
  const Error plain{ErrorCode::too_many_elements, "About 5 elements would be needed.", {}};
  CHECK(chart_words(plain) == plain.message);
}

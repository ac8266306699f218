// Smoothing does no harm and much good.
#include "cleanup/smooth.h"

#include "catch.h"
#include "cleanup/quad_topology.h"
#include "cleanup/untangle.h"
#include "mesh/quality.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("a shaken grid becomes a grid again") {
  QuadMesh mesh = shaken(grid(10, 10), 0.25);
  smooth_eta(mesh, uniform_fields(mesh, 1), {.iterations = 200});
  const QuadQuality quality = quad_quality(mesh);
  CHECK(quality.eta_mean > 0.999);
  CHECK(quality.eta_min > 0.995);
}

TEST_CASE("smoothing never lowers the worst eta, never moves the boundary, keeps validity") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    QuadMesh start = scrambled(10, 8, 12, seed);
    untangle(start);
    const std::size_t invalid = invalid_faces(start).size();
    const QuadQuality before = quad_quality(start);
    QuadMesh mesh = start;
    smooth_eta(mesh, uniform_fields(mesh, 1));
    const QuadQuality after = quad_quality(mesh);
    CHECK(after.eta_min >= before.eta_min);
    CHECK(after.eta_mean > before.eta_mean);
    CHECK(invalid_faces(mesh).size() <= invalid);
    for (Index v = 0; v < mesh.fixed; ++v) CHECK(mesh.points[v] == start.points[v]);
    CHECK(mesh.faces == start.faces);
  }
}

TEST_CASE("invalid faces stay as they are and do not stop the rest") {
  QuadMesh mesh = shaken(grid(12, 12), 0.2, 2);
  const Csr<Index> stars = faces_at_vertices(mesh);
  const Index v = mesh.fixed;
  mesh.points[v] = {4, 4};  // far outside its star
  const QuadMesh start = mesh;
  const std::vector<Index> invalid = invalid_faces(mesh);
  REQUIRE(!invalid.empty());
  smooth_eta(mesh, uniform_fields(mesh, 1));
  for (const Index f : invalid)
    for (const Index w : mesh.faces[f]) CHECK(mesh.points[w] == start.points[w]);
  CHECK(quad_quality(mesh).eta_mean > quad_quality(start).eta_mean);
}

TEST_CASE("triangles are tolerated and stay valid") {
  QuadMesh mesh = shaken(grid(6, 6), 0.25, 4);
  const Face last = mesh.faces.back();
  mesh.faces.back() = {last[0], last[1], last[2], none};
  mesh.faces.push_back({last[0], last[2], last[3], none});
  mesh.region.push_back(0);
  smooth_eta(mesh, uniform_fields(mesh, 1));
  CHECK(invalid_faces(mesh).empty());
}

TEST_CASE("a needle beside a good mesh does not stop its smoothing") {
  // Regression: one nearly flat face made every line search fail.
  QuadMesh mesh = shaken(grid(12, 12), 0.25, 6);
  const QuadMesh start = mesh;
  const Face corner = mesh.faces[0];
  REQUIRE(mesh.points[corner[0]] == Vec2{0, 0});
  mesh.points[corner[0]] = 0.49999999 * (mesh.points[corner[1]] + mesh.points[corner[3]]);
  REQUIRE(invalid_faces(mesh).empty());
  smooth_eta(mesh, uniform_fields(mesh, 1));
  CHECK(invalid_faces(mesh).empty());
  CHECK(quad_quality(mesh).eta_mean > 0.97);
}

TEST_CASE("the length term pulls edges towards h") {
  // Free strips of a wide grid may shrink or grow; with the term they stay nearer to h.
  QuadMesh mesh = grid(4, 16);
  for (std::size_t v = mesh.fixed; v < mesh.points.size(); ++v)
    mesh.points[v].x = mesh.points[v].x < 2 ? 0.3 : mesh.points[v].x > 2 ? 3.7 : 2;
  QuadMesh with = mesh, without = mesh;
  smooth_eta(with, uniform_fields(mesh, 1), {.size_weight = 0.3});
  smooth_eta(without, uniform_fields(mesh, 1), {.size_weight = 0});
  const auto spread = [](const QuadMesh& m) {
    double sum = 0;
    for (const Face& face : m.faces)
      for (int k = 0; k < 4; ++k) {
        const double s = distance(m.points[face[k]], m.points[face[(k + 1) & 3]]);
        sum += (s - 1) * (s - 1);
      }
    return sum;
  };
  CHECK(spread(with) < spread(without));
}

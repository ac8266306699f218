#include "recombine/recombine.h"

#include <set>

#include "base/hash.h"
#include "catch.h"
#include "matching/certificate.h"
#include "mesh/quality.h"
#include "mesh/validate.h"
#include "recombine/assemble.h"
#include "recombine/pair_cost.h"
#include "support/mesh_checks.h"
#include "support/tiny_meshes.h"

using namespace lpq;
using namespace lpq_test;
using lpq_test::Approx;

namespace {

RecombineResult run(const TriMesh& mesh, bool all_quads = true) {
  RecombineOptions options;
  options.all_quads = all_quads;
  options.keep_matching = true;
  return recombine(mesh, Fields{}, options);
}

/// Everything that holds whatever the triangulation: conformity, counts, area, walls, certificate.
void check_result(const TriMesh& mesh, const RecombineResult& result) {
  const DirectedEdges boundary = outer_boundary(mesh);
  const std::vector<Vec2> given(mesh.points.begin(), mesh.points.begin() + mesh.fixed);
  CHECK(sentences(topology_faults(result.mesh, {boundary, given})) == "");
  CHECK(signed_area(result.mesh) == Approx(signed_area(mesh)).epsilon(1e-12));
  CHECK(result.mesh.walls == inner_walls(mesh));
  const QuadQuality quality = quad_quality(result.mesh);
  CHECK(quality.triangles == result.triangles);
  const Index triangles = mesh.triangle_count() + 2 * result.splits;
  CHECK(2 * quality.quads + quality.triangles == triangles + 2 * result.extra_edges);
  CHECK(static_cast<Index>(result.mesh.points.size()) ==
        mesh.vertex_count() + result.splits + result.extra_edges);
  CHECK(result.triangulation.triangle_count() == triangles);
  const auto nodes = static_cast<Index>(result.matching.mate.size());
  CHECK(check_certificate(nodes, result.graph, result.matching) == "");
  for (Index t = 0; t < triangles; ++t)
    if (result.pair_of[t] != none) CHECK(result.pair_of[result.pair_of[t]] == t);
}

void check_all_quads(const TriMesh& mesh, const RecombineResult& result) {
  check_result(mesh, result);
  CHECK(result.status == RecombineStatus::all_quads);
  CHECK(result.triangles == 0);
}

std::uint64_t fingerprint(const QuadMesh& mesh) {
  Fnv1a hash;
  hash.add(std::span<const Vec2>(mesh.points));
  hash.add(std::span<const Face>(mesh.faces));
  return hash.value();
}

/// Number of parts between walls with an odd number of triangles.
Index odd_parts(const TriMesh& mesh) {
  std::vector<char> seen(mesh.triangles.size(), 0);
  Index odd = 0;
  for (Index start = 0; start < mesh.triangle_count(); ++start) {
    if (seen[start]) continue;
    std::vector<Index> part{start};
    seen[start] = 1;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Index e = 3 * part[i]; e < 3 * part[i] + 3; ++e)
        if (mesh.twins[e] != none && !seen[triangle_of(mesh.twins[e])])
          seen[triangle_of(mesh.twins[e])] = 1, part.push_back(triangle_of(mesh.twins[e]));
    odd += static_cast<Index>(part.size() % 2);
  }
  return odd;
}

/// A regular fan of n triangles around the vertex at the origin, on an arc of `degrees`.
TriMesh half_disc(int n, double degrees = 180) {
  std::vector<Vec2> points{{0, 0}};
  std::vector<Tri> triangles;
  for (int k = 0; k <= n; ++k) {
    const double angle = k * degrees / n * std::acos(-1.0) / 180;
    points.push_back({std::cos(angle), std::sin(angle)});
    if (k > 0) triangles.push_back({0, k, k + 1});
  }
  return make_tri_mesh(points, triangles, static_cast<Index>(points.size()));
}

}  // namespace

TEST_CASE("grids give back their squares") {
  for (auto [nx, ny] : {std::array{1, 1}, {1, 4}, {3, 3}, {7, 5}, {20, 30}})
    for (bool alternate : {false, true}) {
      const TriMesh mesh = grid_triangles(nx, ny, alternate);
      const RecombineResult result = run(mesh);
      check_all_quads(mesh, result);
      CHECK(quad_quality(result.mesh).eta_min == Approx(1));
      CHECK(quad_quality(result.mesh).quads == nx * ny);
      CHECK(result.extra_edges == 0);
      CHECK(sentences(validate(result.mesh, {outer_boundary(mesh)})) == "");
    }
}

TEST_CASE("a shuffled triangulation of a grid") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    TriMesh mesh = grid_triangles(9, 7, seed % 2 == 0);
    shuffle_edges(mesh, rng, static_cast<int>(rng.below(600)));
    check_all_quads(mesh, run(mesh));
  }
}

TEST_CASE("random walls: never crossed, one triangle for each odd part") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed, 1);
    TriMesh mesh = grid_triangles(9, 7, seed % 2 == 0);
    shuffle_edges(mesh, rng, 200);
    for (auto k = rng.below(60); k > 0; --k)
      cut(mesh, static_cast<Index>(rng.below(mesh.twins.size())));
    const RecombineResult result = run(mesh);
    check_result(mesh, result);
    CHECK(result.triangles == odd_parts(mesh));
    CHECK((result.status == RecombineStatus::all_quads) == (result.triangles == 0));
  }
}

TEST_CASE("the cost adds up and the same input gives the same bits") {
  Rng rng(3);
  TriMesh mesh = grid_triangles(12, 12);
  shuffle_edges(mesh, rng, 900);
  const RecombineResult once = run(mesh), twice = run(mesh);
  CHECK(fingerprint(once.mesh) == fingerprint(twice.mesh));
  std::int64_t cost = 0;
  for (Index t = 0; t < once.triangulation.triangle_count(); ++t)
    if (once.matching.mate[t] > t) cost += once.graph[once.matching.edge[t]].cost;
  CHECK(cost == once.matching.cost);
}

TEST_CASE("a fan around one wall vertex needs its extra edge") {
  // Of the triangles in a row, 1-2 3-4 5-6 merge; the extra edge 1-6 would be dearer.
  //      3---2
  //     / \ / \ .
  //    4---0---1
  const TriMesh six = half_disc(6);
  const RecombineResult even = run(six);
  check_all_quads(six, even);
  CHECK(even.extra_edges == 0);
}

TEST_CASE("an extra edge is chosen when nothing else is perfect") {
  // Three ears around triangle 0 2 4 would leave two; vertices 0, 2 and 4 have fans of three
  // triangles whose ends are ears.
  //          4
  //         / \ .
  //     5  /   \  3
  //       /     \ .
  //      0 ----- 2
  //          1
  const double s = std::sqrt(3.0) / 2;
  const TriMesh mesh = make_tri_mesh({{0, 0}, {0.5, -s}, {1, 0}, {1, s}, {0.5, s}, {0, s}},
                                     {{0, 2, 4}, {0, 1, 2}, {2, 3, 4}, {4, 5, 0}}, 6);
  const RecombineResult result = run(mesh);
  check_all_quads(mesh, result);
  CHECK(result.extra_edges == 1);
  CHECK(result.splits == 0);
  CHECK(quad_quality(result.mesh).quads == 3);
}

TEST_CASE("where no perfect matching exists, a split makes one") {
  // Random walls break the fans, so that extra edges alone do not help everywhere.
  Index repaired = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Rng rng(seed, 77);
    const int nx = 1 + static_cast<int>(rng.below(12)), ny = 1 + static_cast<int>(rng.below(12));
    TriMesh mesh = grid_triangles(nx, ny, seed % 2 == 1);
    shuffle_edges(mesh, rng, static_cast<int>(rng.below(20 * nx * ny)));
    for (auto k = rng.below(3 * nx * ny); k > 0; --k)
      cut(mesh, static_cast<Index>(rng.below(mesh.twins.size())));
    const RecombineResult result = run(mesh);
    if (result.splits == 0) continue;
    ++repaired;
    check_result(mesh, result);
    CHECK(result.triangles == odd_parts(mesh));
  }
  CHECK(repaired > 5);
}

TEST_CASE("a part of odd size keeps exactly one triangle") {
  const TriMesh five = half_disc(5);
  const RecombineResult result = run(five);
  check_result(five, result);
  CHECK(result.status == RecombineStatus::triangles_left);
  CHECK(result.triangles == 1);
  const TriMesh one = half_disc(1, 60);
  CHECK(run(one).triangles == 1);
  CHECK(run(one).mesh.faces.size() == 1);
}

TEST_CASE("a left-over triangle pays for its own shape") {
  for (const TriMesh& part : {half_disc(5), half_disc(7, 300)}) {
    const RecombineResult result = run(part);
    const Index triangles = part.triangle_count();
    REQUIRE(std::max(result.graph.back().u, result.graph.back().v) == triangles);
    for (const CostEdge& edge : result.graph) {
      if (std::max(edge.u, edge.v) < triangles) continue;
      const auto [a, b, c] = part.triangles[std::min(edge.u, edge.v)];
      const double eta = triangle_eta(part.points[a], part.points[b], part.points[c]);
      CHECK(static_cast<double>(edge.cost) == Approx(1e4 * (1 - eta)).margin(0.51));
    }
  }
}

TEST_CASE("regions are kept and their border is a wall") {
  TriMesh mesh = grid_triangles(6, 4);
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    double x = 0;
    for (Index v : mesh.triangles[t]) x += mesh.points[v].x / 3;
    mesh.region[t] = x > 3.0 / 8 ? 1 : 0;
  }
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e)
    if (mesh.twins[e] != none && mesh.region[e / 3] != mesh.region[mesh.twins[e] / 3]) cut(mesh, e);
  const RecombineResult result = run(mesh);
  check_all_quads(mesh, result);
  CHECK(result.mesh.walls.size() == 4);
  Index count[2] = {0, 0};
  for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
    ++count[result.mesh.region[f]];
    for (Index v : result.mesh.faces[f])
      CHECK((result.mesh.region[f] == 0 ? result.mesh.points[v].x <= 3.0 / 8
                                        : result.mesh.points[v].x >= 3.0 / 8));
  }
  CHECK(count[0] == 12);
  CHECK(count[1] == 12);
}

TEST_CASE("the end of a wall inside: a full turn that no extra edge may halve") {
  TriMesh mesh = grid_triangles(4, 4);
  const Vec2 center{0.5, 0.5};
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e)
    if (mesh.points[mesh.origin(e)] == center && mesh.points[mesh.target(e)] == Vec2{0.75, 0.5})
      cut(mesh, e);
  Rng rng(11);
  for (int round = 0; round < 30; ++round) {
    shuffle_edges(mesh, rng, 60);
    const RecombineResult result = run(mesh);
    check_all_quads(mesh, result);
    CHECK(result.mesh.walls.size() == 1);
  }
}

TEST_CASE("quad-dominant: triangles stay where merging costs more") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Rng rng(seed, 5);
    TriMesh mesh = grid_triangles(8, 8, seed % 2 == 0);
    shuffle_edges(mesh, rng, 500);
    const RecombineResult all = run(mesh), some = run(mesh, false);
    check_result(mesh, some);
    CHECK(some.extra_edges == 0);
    if (some.triangles > 0) CHECK(some.status == RecombineStatus::triangles_left);
    CHECK(quad_quality(some.mesh).eta_mean >= quad_quality(all.mesh).eta_mean);
  }
  const TriMesh grid = grid_triangles(5, 3);
  CHECK(run(grid, false).triangles == 0);
}

TEST_CASE("misalignment is 0 along the cross, 1 at 45 degrees, and knows no quarter turns") {
  const Vec2 square[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(misalignment(square, {1, 0}) == Approx(0).margin(1e-15));
  CHECK(misalignment(square, {-1, 0}) == Approx(1));
  Rng rng(9);
  for (int i = 0; i < 1000; ++i) {
    Vec2 quad[4], turned[4];
    for (int k = 0; k < 4; ++k) {
      quad[k] = square[k] + Vec2{rng.between(-0.4, 0.4), rng.between(-0.4, 0.4)};
      turned[k] = perpendicular(quad[k]);
    }
    const double theta = rng.between(-1, 1);
    const Vec2 z{std::cos(4 * theta), std::sin(4 * theta)};
    double expected = 0;
    for (int k = 0; k < 4; ++k) {
      const Vec2 side = quad[(k + 1) % 4] - quad[k];
      expected += (1 - std::cos(4 * (std::atan2(side.y, side.x) - theta))) / 8;
    }
    CHECK(misalignment(quad, z) == Approx(expected).margin(1e-12));
    CHECK(misalignment(turned, z) == Approx(expected).margin(1e-12));
  }
}

TEST_CASE("a field sampled from a coarse background") {
  // A cross along the axes agrees with the squares.
  const TriMesh mesh = grid_triangles(6, 6);
  Fields fields;
  fields.background = grid_triangles(1, 1);
  fields.h.assign(4, 0.125);
  fields.z.assign(4, {1, 0});
  fields.attach();
  const RecombineResult result = recombine(mesh, fields);
  CHECK(quad_quality(result.mesh).eta_min == Approx(1));
}

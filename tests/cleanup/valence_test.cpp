// The ideal numbers of quads.
#include "catch.h"
#include "cleanup/ideal_valence.h"
#include "numerics/elementary.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("a grid is regular everywhere") {
  const QuadTopology mesh(grid(4, 3));
  const IdealValence ideal(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) CHECK(ideal.is_regular(mesh, v));
}

TEST_CASE("in a part of a larger mesh four quads are wanted on the rim, with those outside") {
  QuadMesh part = grid(4, 3);
  part.outside.assign(part.fixed, 0);
  const QuadTopology plain{QuadMesh(part)};
  for (Index v = 0; v < part.fixed; ++v) part.outside[v] = 4 - plain.valence(v);
  part.outside[0] = none;  // as before: a corner of the outline
  const Index last = part.fixed - 1;
  part.outside[last] += 1;
  const QuadTopology mesh{QuadMesh(part)};
  const IdealValence ideal(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) CHECK(ideal.is_regular(mesh, v) == (v != last));
  CHECK(ideal.weight(mesh, last) == irregularity(5, 4, false));
}

TEST_CASE("around a hole of few edges two quads or three are taken, at a corner they are not") {
  for (const Index n : {4, 6, 7, 8}) {
    QuadMesh ring;
    for (const double r : {1.0, 2.0})
      for (Index k = 0; k < n; ++k) {
        const auto [sin, cos] = sin_cos(2 * pi * k / n);
        ring.points.push_back({r * cos, r * sin});
      }
    for (Index k = 0; k < n; ++k) ring.faces.push_back({k, n + k, n + (k + 1) % n, (k + 1) % n});
    ring.fixed = 2 * n;
    const QuadTopology mesh{QuadMesh(ring)};
    const IdealValence ideal(mesh);
    for (Index v = 0; v < n; ++v) {
      const auto count = ideal.sector_count(mesh, v, mesh.faces_of(v)[0]);
      CHECK(count.either == (n > 4));
      CHECK(count.quads == 2);
      CHECK(count.ideal == 3);
      CHECK(ideal.weight(mesh, v) == count.weight(2));
      CHECK((count.weight(2) < irregularity(3, 4, false)) == (n > 4));
      CHECK(count.weight(3) == 0);
      CHECK(count.weight(4) > 1);
    }
  }
}

TEST_CASE("walls cut a vertex into sectors with their own ideals") {
  // A wall along the middle of a grid from the left side to a tip inside.
  QuadMesh plain = grid(4, 4);
  std::vector<Index> order;  // fixed first: the middle row's two inner vertices become fixed
  QuadMesh mesh = plain;
  const auto find = [&](double x, double y) {
    for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v)
      if (mesh.points[v] == Vec2{x, y}) return v;
    return none;
  };
  const auto swap_to_front = [&](Index v) {
    const Index w = mesh.fixed++;
    std::swap(mesh.points[v], mesh.points[w]);
    for (Face& face : mesh.faces)
      for (Index& c : face) c = c == v ? w : c == w ? v : c;
    return w;
  };
  const Index start = find(0, 2), middle = swap_to_front(find(1, 2)),
              tip = swap_to_front(find(2, 2));
  mesh.walls = {{std::min(start, middle), std::max(start, middle)}, {middle, tip}};
  std::sort(mesh.walls.begin(), mesh.walls.end());
  const QuadTopology topology(mesh);
  const IdealValence ideal(topology);
  CHECK(ideal.is_regular(topology, start));
  CHECK(ideal.is_regular(topology, middle));
  CHECK(ideal.is_regular(topology, tip));
  for (const Index f : topology.faces_of(start)) {
    CHECK(ideal.sector_count(topology, start, f).quads == 1);
    CHECK(ideal.sector_count(topology, start, f).ideal == 1);
  }
  for (const Index f : topology.faces_of(middle)) {
    CHECK(ideal.sector_count(topology, middle, f).quads == 2);
    CHECK(ideal.sector_count(topology, middle, f).ideal == 2);
  }
  for (const Index f : topology.faces_of(tip))
    CHECK(ideal.sector_count(topology, tip, f).ideal == 4);
}

TEST_CASE("missing boundary quads cost most") {
  CHECK(irregularity(4, 4, false) == 0);
  CHECK(irregularity(3, 4, false) == irregularity(5, 4, false));
  CHECK(irregularity(2, 4, false) > irregularity(6, 4, false));
  CHECK(irregularity(1, 2, true) > irregularity(3, 2, true));
  CHECK(irregularity(3, 2, true) > irregularity(5, 4, false));
}

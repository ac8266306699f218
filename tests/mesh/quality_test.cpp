#include "mesh/quality.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"
#include "support/tiny_meshes.h"

using namespace lpq;
using namespace lpq_test;
using lpq_test::Approx;

namespace {

/// eta by its definition, with the C library's atan2.
double eta_by_definition(const Vec2 (&p)[4]) {
  double worst = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec2 along = p[(k + 1) % 4] - p[k], back = p[(k + 3) % 4] - p[k];
    double alpha = std::atan2(cross(along, back), dot(along, back));
    if (alpha < 0) alpha += 2 * pi;
    worst = std::max(worst, std::abs(pi / 2 - alpha));
  }
  return std::max(1 - 2 / pi * worst, 0.0);
}

}  // namespace

TEST_CASE("eta of known quads") {
  CHECK(quad_eta({0, 0}, {1, 0}, {1, 1}, {0, 1}) == 1);
  CHECK(quad_eta({0, 0}, {3, 0}, {3, 1}, {0, 1}) == 1);
  // A rhombus of 60 and 120 degrees: 1 - 30/90.
  const double s = std::sqrt(3.0) / 2;
  CHECK(quad_eta({0, 0}, {1, 0}, {1.5, s}, {0.5, s}) == Approx(2.0 / 3).epsilon(1e-14));
  // A straight angle, a reflex angle, a clockwise square, a point.
  CHECK(quad_eta({0, 0}, {1, 0}, {2, 0}, {1, 1}) == 0);
  CHECK(quad_eta({0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}) == 0);
  CHECK(quad_eta({0, 0}, {0, 1}, {1, 1}, {1, 0}) == 0);
  CHECK(quad_eta({0, 0}, {0, 0}, {0, 0}, {0, 0}) == 0);
}

TEST_CASE("eta agrees with its definition on random quads, convex or not") {
  Rng rng(1);
  int positive = 0;
  for (int i = 0; i < 20000; ++i) {
    Vec2 p[4];
    for (int k = 0; k < 4; ++k)
      p[k] = {(k == 1 || k == 2) + rng.between(-0.6, 0.6), (k >= 2) + rng.between(-0.6, 0.6)};
    const double eta = quad_eta(p[0], p[1], p[2], p[3]);
    CHECK(eta == Approx(eta_by_definition(p)).margin(1e-14));
    CHECK(eta == Approx(quad_eta(p[1], p[2], p[3], p[0])).margin(1e-15));
    // Scaling by a power of two changes no bit.
    CHECK(eta == quad_eta(0x1p-20 * p[0], 0x1p-20 * p[1], 0x1p-20 * p[2], 0x1p-20 * p[3]));
    positive += eta > 0;
  }
  CHECK(positive > 5000);
}

TEST_CASE("tau is 1 for right-angled triangles and sin 60 for equilateral ones") {
  CHECK(tau(grid_triangles(3, 2)) == Approx(1).epsilon(1e-15));
  const double s = std::sqrt(3.0) / 2;
  CHECK(tau(make_tri_mesh({{0, 0}, {1, 0}, {0.5, s}}, {{0, 1, 2}}, 3)) == Approx(s).epsilon(1e-14));
}

TEST_CASE("quality of a grid") {
  const QuadQuality quality = quad_quality(grid_quads(5, 4));
  CHECK(quality.quads == 20);
  CHECK(quality.triangles == 0);
  CHECK(quality.eta_min == Approx(1));
  CHECK(quality.eta_mean == Approx(1));
  CHECK(quality.eta_p5 == Approx(1));
  CHECK(quality.interior_vertices == 12);
  CHECK(quality.regular_vertices == 12);
  CHECK(quality.four_valent_percent == 100);
  CHECK(quality.valence_histogram[4] == 12);
  CHECK(quality.eta_histogram[19] == 20);
  CHECK(quality.inverted == 0);
  CHECK(quality.nonconvex == 0);
}

TEST_CASE("valence counts edges at vertices off the rim, whatever is fixed") {
  // A hexagon of three rhombi around one inner vertex of valence 3.
  //     3---2
  //    / \ / \ .
  //   4   6---1       faces 6123, 6345, 6501 (the inner vertex sees 1, 3 and 5)
  //    \ / \ / .
  //     5---0
  QuadMesh mesh;
  const double s = std::sqrt(3.0) / 2;
  mesh.points = {{0.5, -s}, {1, 0}, {0.5, s}, {-0.5, s}, {-1, 0}, {-0.5, -s}, {0, 0}};
  mesh.faces = {{6, 1, 2, 3}, {6, 3, 4, 5}, {6, 5, 0, 1}};
  mesh.region = {0, 0, 0};
  for (Index fixed : {6, 7}) {
    mesh.fixed = fixed;
    const QuadQuality quality = quad_quality(mesh);
    CHECK(quality.interior_vertices == 1);
    CHECK(quality.regular_vertices == 0);
    CHECK(quality.valence_histogram[3] == 1);
    CHECK(quality.four_valent_percent == 0);
    CHECK(quality.eta_min == Approx(2.0 / 3));
  }
}

TEST_CASE("inverted and non-convex faces are counted") {
  QuadMesh mesh = grid_quads(2, 2);
  CHECK(quad_quality(mesh).nonconvex == 0);
  mesh.points[8] = {0.1, 0.1};  // still convex everywhere? the quad at the corner is not any more
  const QuadQuality moved = quad_quality(mesh);
  CHECK(moved.inverted == 0);
  CHECK(moved.eta_min < 0.5);
  mesh.points[8] = {-0.2, -0.2};
  CHECK(quad_quality(mesh).nonconvex > 0);
  mesh = grid_quads(1, 1);
  std::swap(mesh.faces[0][1], mesh.faces[0][3]);
  CHECK(quad_quality(mesh).inverted == 1);
}

TEST_CASE("the percentile interpolates between order statistics") {
  // Two separate quads with eta 1 and 2/3: the 5th percentile is 2/3 + 0.05 / 3.
  QuadMesh mesh;
  const double s = std::sqrt(3.0) / 2;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 0}, {6, 0}, {6.5, s}, {5.5, s}};
  mesh.faces = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  mesh.region = {0, 0};
  CHECK(quad_quality(mesh).eta_p5 == Approx(2.0 / 3 + 0.05 / 3).epsilon(1e-13));
}

TEST_CASE("eta of a triangle: 1 at three times 60 degrees, 0 where it is flat") {
  const double s = std::sqrt(3.0) / 2;
  CHECK(triangle_eta({0, 0}, {1, 0}, {0.5, s}) == Approx(1).epsilon(1e-14));
  CHECK(triangle_eta({0, 0}, {1, 0}, {0, 2 * s}) == Approx(0.5).epsilon(1e-14));  // 30, 60, 90
  CHECK(triangle_eta({0, 0}, {1, 0}, {-0.5, s}) == Approx(0.5).epsilon(1e-14));   // 30, 30, 120
  CHECK(triangle_eta({0, 0}, {1, 0}, {2, 0}) == 0);
  CHECK(triangle_eta({0, 0}, {0, 1}, {1, 0}) == 0);  // clockwise
  CHECK(triangle_eta({0, 0}, {1, 0}, {0.5, 1e-3}) < 0.01);
}

TEST_CASE("triangles among quads") {
  QuadMesh mesh = grid_quads(2, 1);
  const Face last = mesh.faces.back();
  mesh.faces.back() = {last[0], last[1], last[2], none};
  mesh.faces.push_back({last[0], last[2], last[3], none});
  mesh.region.push_back(0);
  const QuadQuality quality = quad_quality(mesh);
  CHECK(quality.quads == 1);
  CHECK(quality.triangles == 2);
  CHECK(quality.inverted == 0);
  CHECK(face_eta(mesh.points, mesh.faces.back()) == Approx(0.75));  // 45, 45, 90 degrees
  CHECK(face_eta(mesh.points, mesh.faces.front()) == Approx(1));
}

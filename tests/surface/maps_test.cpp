// Single maps against what geometry says they are: isometries of what unrolls, the stereographic
// projection of a cap, and the invariants of flips.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "numerics/elementary.h"
#include "support/map_checks.h"
#include "support/surface_meshes.h"
#include "surface/charts/bff.h"
#include "surface/charts/checks.h"
#include "surface/charts/conformal.h"
#include "surface/charts/dirichlet.h"
#include "surface/charts/split.h"

using namespace lpq;
using namespace lpq_test;

namespace {

Part whole(const SurfaceMesh& mesh, const std::vector<char>& cut) {
  std::vector<Index> all;
  for (Index t = 0; t < mesh.triangle_count(); ++t) all.push_back(t);
  return PartTaker(mesh).take(all, cut);
}
Part whole(const SurfaceMesh& mesh) { return whole(mesh, std::vector<char>(mesh.twins.size(), 0)); }

// Cut along the shortest way between its two borders.
Part opened(const SurfaceMesh& mesh) {
  std::vector<char> cut(mesh.twins.size(), 0);
  for (const Index e : Splitter(mesh).way_to_next_loop(whole(mesh)))
    cut[e] = cut[mesh.twins[e]] = 1;
  return whole(mesh, cut);
}

Intrinsic delaunay_of(const SurfaceMesh& mesh, const Part& part) {
  Intrinsic surface = intrinsic_of(mesh, part);
  flip_to_delaunay(surface);
  return surface;
}

std::vector<Vec2> bff_of(const SurfaceMesh& mesh, const Part& part) {
  std::vector<Vec2> uv;
  REQUIRE(map_bff(part, delaunay_of(mesh, part), 100, uv) == MapOutcome::mapped);
  return uv;
}

double worst_length_error(const Part& part, const std::vector<Vec2>& uv) {
  double worst = 0;
  for (Index e = 0; e < static_cast<Index>(part.twins.size()); ++e) {
    const double l = distance(uv[part.origin(e)], uv[part.target(e)]);
    worst = std::max(worst, std::abs(l / part.length[e] - 1));
  }
  return worst;
}

// A square of n x n with heights of a rough but repeatable kind.
SurfaceMesh rough_square(int n, double height) {
  return grid_surface(n, n, [=](double u, double v) {
    return Vec3{u, v, height * std::sin(37 * u + 23 * v * v) * std::cos(41 * v)};
  });
}

double area_of(const Intrinsic& surface) {
  double sum = 0;
  for (std::size_t e = 0; e < surface.length.size(); e += 3)
    sum += four_areas({surface.length[e], surface.length[e + 1], surface.length[e + 2]}) / 4;
  return sum;
}

}  // namespace

TEST_CASE("parts have the topology of what was cut out") {
  CHECK(whole(sphere(4)).loops.rows() == 0);
  CHECK(whole(sphere(4)).genus() == 0);
  CHECK(whole(torus(12, 8, 3, 1)).genus() == 1);
  const SurfaceMesh tube = cylinder(12, 5, 1, 2);
  const Part part = whole(tube);
  CHECK(part.loops.rows() == 2);
  CHECK(part.genus() == 0);
  CHECK(part.vertex_count() == tube.vertex_count());
  const Part disk = opened(tube);
  CHECK(is_disk(disk));
  CHECK(disk.vertex_count() == tube.vertex_count() + 6);
  CHECK(disk.loops.offsets.back() == 24 + 10);
}

TEST_CASE("flips to Delaunay keep area and curvature and leave no negative weight") {
  for (const SurfaceMesh& mesh : {rough_square(24, 0.08), rough_square(9, 0.4)}) {
    const Part part = whole(mesh);
    const Intrinsic before = intrinsic_of(mesh, part);
    Intrinsic after = before;
    flip_to_delaunay(after);
    CHECK((after.corners != before.corners));
    CHECK(std::abs(area_of(after) / area_of(before) - 1) < 1e-10);
    const std::vector<double> a = angle_sums(before), b = angle_sums(after);
    double worst = 0;
    for (std::size_t v = 0; v < a.size(); ++v) worst = std::max(worst, std::abs(a[v] - b[v]));
    CHECK(worst < 1e-9);
    const std::vector<double> weights = half_cotangents(after);
    for (std::size_t e = 0; e < weights.size(); ++e) {
      if (after.twins[e] == none) continue;
      CHECK(weights[e] + weights[after.twins[e]] > -1e-8);
      CHECK(after.length[e] == after.length[after.twins[e]]);
    }
  }
}

TEST_CASE("what unrolls is unrolled") {
  CHECK(worst_length_error(whole(plane_square(15)),
                           bff_of(plane_square(15), whole(plane_square(15)))) < 1e-9);
  const SurfaceMesh tube = cylinder(24, 40, 1, 20);
  CHECK(worst_length_error(opened(tube), bff_of(tube, opened(tube))) < 1e-9);
  const SurfaceMesh hat = cone(40, 20, 0.5, 2, 0.6);
  CHECK(worst_length_error(opened(hat), bff_of(hat, opened(hat))) < 1e-9);
}

TEST_CASE("LSCM and SCP unroll up to scale") {
  const SurfaceMesh hat = cone(40, 20, 0.5, 2, 0.6);
  const Part part = opened(hat);
  const Intrinsic disk = delaunay_of(hat, part);
  std::vector<Vec2> uv;
  for (const bool pinned : {true, false}) {
    REQUIRE((pinned ? map_lscm(hat, part, disk, uv) : map_scp(part, disk, uv)));
    const MapCheck check = check_map(hat, part, uv);
    CHECK(is_injective(check));
    CHECK(check.anisotropy < 1 + (pinned ? 1e-6 : 1e-3));
    CHECK(check.scale_range < 1 + (pinned ? 1e-6 : 1e-2));
  }
}

TEST_CASE("a cap of a sphere is projected as a stereographic chart of unit scale on the border") {
  const double opening = 1.2;
  const SurfaceMesh cap = sphere_cap(40, opening);
  const Part part = whole(cap);
  const std::vector<Vec2> uv = bff_of(cap, part);
  const MapCheck check = check_map(cap, part, uv);
  CHECK(is_injective(check));
  CHECK(check.anisotropy < 1.05);
  const std::vector<double> scale = scales_of(cap, part, uv);
  for (Index t = 0; t < cap.triangle_count(); ++t) {
    const auto [a, b, c] = cap.triangles[t];
    const double z = (cap.points[a].z + cap.points[b].z + cap.points[c].z) / 3;
    CHECK(std::abs(scale[t] * (1 + z) / (1 + std::cos(opening)) - 1) < 0.03);
  }
}

TEST_CASE("scales and areas agree") {
  const SurfaceMesh mesh = rough_square(20, 0.05);
  const Part part = whole(mesh);
  const std::vector<Vec2> uv = bff_of(mesh, part);
  const std::vector<double> scale = scales_of(mesh, part, uv);
  double plane = 0, scaled = 0;
  for (Index t = 0; t < part.triangle_count(); ++t) {
    const auto [a, b, c] = part.corners[t];
    plane += 0.5 * cross(uv[b] - uv[a], uv[c] - uv[a]);
    scaled += scale[t] * scale[t] * layout_of(mesh, part.triangles[t]).area;
  }
  CHECK(std::abs(plane / scaled - 1) < 1e-12);
}

TEST_CASE("holes are filled before a plate is mapped, and stay holes") {
  const SurfaceMesh ring = grid_surface(
      40, 10,
      [](double u, double v) {
        const double r = 2 - v;
        return Vec3{r * std::cos(turn * u), r * std::sin(turn * u), 0};
      },
      true);
  const Part part = whole(ring);
  REQUIRE(part.loops.rows() == 2);
  CHECK(loop_length(part, 0) > loop_length(part, 1));
  const std::vector<Vec2> uv = bff_of(ring, part);
  CHECK(worst_length_error(part, uv) < 1e-9);
  CHECK(is_injective(check_map(ring, part, uv)));
}

TEST_CASE("the symmetric Dirichlet map is nearly isometric where that is possible") {
  const SurfaceMesh square = plane_square(12);
  const Part part = whole(square);
  std::vector<Vec2> uv;
  REQUIRE(map_symmetric_dirichlet(square, part, uv));
  const MapCheck check = check_map(square, part, uv);
  CHECK(is_injective(check));
  CHECK(check.anisotropy < 1.1);
  CHECK(check.scale_range < 1.1);
}

TEST_CASE("checks see a flipped triangle and a border that meets itself") {
  const SurfaceMesh square = plane_square(6);
  const Part part = whole(square);
  std::vector<Vec2> uv = bff_of(square, part);
  CHECK(is_injective(check_map(square, part, uv)));
  std::vector<Vec2> folded = uv;
  std::swap(folded[10], folded[20]);
  CHECK(check_map(square, part, folded).flipped > 0);
  // Squared as complex numbers about a point outside, a square covers part of the plane twice once
  // it subtends more than half a turn; drawn as a long strip bent by 400 degrees it does.
  const SurfaceMesh strip = grid_surface(80, 2, [](double u, double v) {
    return Vec3{u, 0.02 * v, 0};
  });
  const Part long_part = whole(strip);
  std::vector<Vec2> bent;
  for (const Index v : long_part.vertex) {
    const Vec3 p = strip.points[v];
    const double angle = -1.1 * turn * p.x, r = 0.2 + p.y;
    bent.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const MapCheck check = check_map(strip, long_part, bent);
  CHECK(check.flipped == 0);
  CHECK(check.crossing);
}

TEST_CASE("borders that lie on each other but for rounding meet, across the outside alone") {
  const auto bent = [](double width, double turns) {
    const SurfaceMesh strip = grid_surface(80, 2, [=](double u, double v) {
      return Vec3{u, width * v, 0};
    });
    const Part part = whole(strip);
    std::vector<Vec2> uv;
    for (const Index v : part.vertex) {
      const double angle = -turns * turn * strip.points[v].x, r = 0.2 + strip.points[v].y;
      uv.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return check_map(strip, part, uv);
  };
  CHECK(bent(0.02, 1 - 1e-12).crossing);  // a ring cut open: the sides of the cut
  CHECK(is_injective(bent(0.02, 1 - 1e-6)));
  CHECK(is_injective(bent(1e-12, 0.5)));  // a hair's sides are near each other across the inside
}

TEST_CASE("checks see a hole that is turned over without any triangle being") {
  // A triangular hole a, b, c in a square of corners on the axes.
  const std::vector<Vec3> points{{-0.5, 0, 0}, {0.5, 0, 0}, {0, 0.2, 0}, {0, 2, 0},
                                 {-2, 0, 0},   {0, -2, 0},  {2, 0, 0}};
  const std::vector<Tri> triangles{{0, 5, 1}, {3, 0, 2}, {3, 2, 1}, {3, 4, 0},
                                   {4, 5, 0}, {5, 6, 1}, {6, 3, 1}};
  const SurfaceMesh frame = SurfaceBuilder().build(points, triangles);
  const Part part = whole(frame);
  std::vector<Vec2> uv;
  for (const Index v : part.vertex) uv.push_back({frame.points[v].x, frame.points[v].y});
  CHECK(is_injective(check_map(frame, part, uv)));
  for (std::size_t i = 0; i < uv.size(); ++i)
    if (part.vertex[i] == 2) uv[i].y = -0.2;
  const MapCheck check = check_map(frame, part, uv);
  CHECK(check.flipped == 0);
  CHECK(check.crossing);
}

TEST_CASE("whether a part is too distorted does not depend on how it is found out") {
  // Factors tell it of 2400 triangles, an estimate of 43,350 where it is clear.
  for (const int rings : {20, 85})
    for (const double opening : {0.4 * pi, 0.75 * pi}) {
      const SurfaceMesh cap = sphere_cap(rings, opening);
      const Part part = whole(cap);
      const Intrinsic disk = delaunay_of(cap, part);
      // The stereographic projection's scale at the pole and at the border.
      const double range = 1 / std::pow(std::cos(opening / 2), 2);
      std::vector<Vec2> uv;
      CHECK(map_bff(part, disk, 1.1 * range, uv) == MapOutcome::mapped);
      CHECK(map_bff(part, disk, 0.9 * range, uv) == MapOutcome::distorted);
    }
}

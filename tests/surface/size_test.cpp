// Sizes on surfaces: what was asked for, finer where it bends, growing no faster than allowed.
#include <cmath>

#include "catch.h"
#include "support/shared_surfaces.h"
#include "support/surface_meshes.h"
#include "surface/curvature.h"
#include "surface/size_field.h"

using namespace lpq;
using namespace lpq_test;

namespace {

std::vector<double> sizes_of(const SurfaceMesh& mesh, const SurfaceSizeOptions& options) {
  auto result = surface_sizes(mesh, sharp_edges(mesh), options);
  REQUIRE(result.has_value());
  return *std::move(result);
}

}  // namespace

TEST_CASE("curvature of a sphere, a cylinder and a plane") {
  SurfaceMesh ball = sphere(24);
  for (Vec3& p : ball.points) p = 2.5 * p;
  for (const SecondForm& form : second_forms(ball, {})) {
    CHECK(std::abs(form.xx - 0.4) < 0.03);
    CHECK(std::abs(form.yy - 0.4) < 0.03);
    CHECK(std::abs(form.xy) < 0.03);
  }
  const SurfaceMesh tube = cylinder(60, 20, 2, 5);
  for (const SecondForm& form : second_forms(tube, {})) {
    CHECK(std::abs(largest_curvature(form) - 0.5) < 0.01);
    CHECK(std::abs(form.xx * form.yy - form.xy * form.xy) < 0.01);
  }
  for (const SecondForm& form : second_forms(plane_square(5), {}))
    CHECK(largest_curvature(form) == 0);
}

TEST_CASE("a crease that is a feature does not count as bending") {
  const SurfaceMesh mesh = cube(6);
  for (const SecondForm& form : second_forms(mesh, sharp_edges(mesh)))
    CHECK(largest_curvature(form) == 0);
}

TEST_CASE("a constant size is constant") {
  SurfaceSizeOptions options;
  options.size = 0.25;
  const SurfaceMesh mesh = torus(20, 10, 3, 1);
  for (const double h : sizes_of(mesh, options)) CHECK(h == 0.25);
  const std::vector<double> h(mesh.points.size(), 0.25);
  CHECK(std::abs(surface_capacity(mesh, h) / (16 * surface_area(mesh)) - 1) < 1e-12);
}

TEST_CASE("a turn gives the chords of a circle") {
  const SurfaceMesh tube = cylinder(90, 30, 2, 6);
  SurfaceSizeOptions turning;
  turning.largest_turn = 0.3;
  for (const double h : sizes_of(tube, turning)) CHECK(std::abs(h - 4 * std::sin(0.15)) < 0.01);
  turning.least = 0.7;
  for (const double h : sizes_of(tube, turning)) CHECK(h == 0.7);
}

TEST_CASE("a round border of a flat plate bends") {
  const SurfaceMesh ring = grid_surface(
      60, 20,
      [](double u, double v) {
        const double r = 3 - 2.5 * v;
        return Vec3{r * std::cos(turn * u), r * std::sin(turn * u), 0};
      },
      true);
  SurfaceSizeOptions options;
  options.size = 2;
  options.largest_turn = 0.5;
  const std::vector<double> h = sizes_of(ring, options);
  for (std::size_t v = 0; v < h.size(); ++v)
    if (length(ring.points[v]) < 0.51) CHECK(std::abs(h[v] - std::sin(0.25)) < 0.01);
}

TEST_CASE("sizes grow along edges no faster than asked, from the caller's values") {
  const SurfaceMesh mesh = sphere(10);
  SurfaceSizeOptions options;
  options.at_vertices.assign(mesh.points.size(), 0);
  options.at_vertices[7] = 0.01;
  options.at_vertices[100] = 0.5;
  options.growth = 0.2;
  const std::vector<double> h = sizes_of(mesh, options);
  CHECK(h[7] == 0.01);
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Index a = mesh.origin(e), b = mesh.target(e);
    CHECK(std::abs(h[a] - h[b]) <= 0.2 * distance(mesh.points[a], mesh.points[b]) * (1 + 1e-12));
  }
}

TEST_CASE("sizes that make no sense are refused") {
  const SurfaceMesh mesh = plane_square(4);
  SurfaceSizeOptions options;
  options.largest_turn = 0.1;  // flat: nothing bends
  const auto flat = surface_sizes(mesh, {}, options);
  REQUIRE(!flat.has_value());
  CHECK(flat.error().code == ErrorCode::bad_size);
  for (const double value : {-1.0, std::nan(""), HUGE_VAL}) {
    SurfaceSizeOptions wrong;
    wrong.size = value;
    CHECK(!surface_sizes(mesh, {}, wrong).has_value());
    wrong.size = 1;
    wrong.at_vertices.assign(mesh.points.size(), value);
    CHECK(!surface_sizes(mesh, {}, wrong).has_value());
  }
  options.size = 1;
  options.growth = 0;
  CHECK(!surface_sizes(mesh, {}, options).has_value());
}

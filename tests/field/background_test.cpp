// The background: covers the domain, stays small, scales without a changed bit.
#include "field/background.h"

#include <cstring>

#include "base/hash.h"
#include "base/rng.h"
#include "catch.h"
#include "field/inside.h"
#include "field/make_fields.h"
#include "support/field_shapes.h"

using namespace lpq;
using namespace lpq::test;

namespace {

double area_of(const TriMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += 0.5 * cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  return sum;
}

Fields fields_of(const BoundaryMesh& boundary) {
  auto result = make_fields(boundary);
  REQUIRE(result.has_value());
  return std::move(*result);
}

}  // namespace

TEST_CASE("regions_of agrees with the shape of the domain") {
  const auto boundary = annulus_boundary(64, 32);
  std::vector<Vec2> points;
  Rng rng(9);
  for (int i = 0; i < 4000; ++i) points.push_back({rng.between(-0.1, 1.1), rng.between(-0.1, 1.1)});
  for (const Vec2 node : boundary.points) points.push_back({0.5, node.y});  // heights of nodes
  const auto region = regions_of(boundary, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = distance(points[i], {0.5, 0.5});
    if (r < 0.198 || r > 0.501) CHECK(region[i] == none);
    if (r > 0.201 && r < 0.498) CHECK(region[i] == 0);
  }
}

TEST_CASE("the background fills the domain with few vertices") {
  const Fields fields = fields_of(square_boundary(0.01));
  CHECK(std::abs(area_of(fields.background) - 1) < 1e-12);
  CHECK(fields.background.vertex_count() < 400 * 5 + 10000 / 3);
  const auto saw = graded_saw(16);
  const Fields graded = fields_of(saw);
  CHECK(graded.background.vertex_count() < 4000);
  for (const double h : graded.h) CHECK(h > 0);
}

TEST_CASE("needles do not fill their surroundings with cells") {
  // A long sliver ending in a tiny edge once asked for millions of leaves beside it.
  const auto boundary = boundary_of({{{0, 0}, {1, 1e-9}, {1, 2e-9}, {0.5, 1.2e-9}, {0, 1e-9}}});
  const Fields fields = fields_of(boundary);
  CHECK(fields.background.vertex_count() < 1000);
}

TEST_CASE("a slanting strip does not fill its bounding square with cells") {
  // 4e8 cells of side 1/2 would fit into the square.
  const auto boundary = boundary_of({{{0, 0}, {8000, 6000}, {7999.4, 6000.8}, {-0.6, 0.8}}});
  const auto background = BackgroundBuilder(boundary, {}, 0.5).coarse();
  REQUIRE(background.has_value());
  CHECK(std::abs(area_of(*background) - 10000) < 1e-6);
  CHECK(background->vertex_count() > 10000 / (0.5 * 0.5) / 2);
  CHECK(background->vertex_count() < 2 * 10000 / (0.25 * 0.25));
}

TEST_CASE("scaling by a power of two changes no bit") {
  for (const auto& boundary : {plate_with_hole(0.05, 24), graded_saw(8)}) {
    const Fields one = fields_of(boundary);
    for (const double scale : {0x1p-30, 0x1p+20}) {
      const Fields other = fields_of(scaled(boundary, scale));
      REQUIRE(other.background.triangles == one.background.triangles);
      REQUIRE(other.z.size() == one.z.size());
      bool same = true;
      for (std::size_t v = 0; v < one.z.size(); ++v)
        same &= other.z[v] == one.z[v] && other.h[v] == scale * one.h[v];
      CHECK(same);
    }
  }
}

TEST_CASE("the same input gives the same bits") {
  const auto hash = [] {
    const Fields fields = fields_of(plate_with_hole(0.05, 24));
    Fnv1a state;
    state.add(std::span<const Vec2>(fields.z));
    state.add(std::span<const double>(fields.h));
    return state.value();
  };
  CHECK(hash() == hash());
}

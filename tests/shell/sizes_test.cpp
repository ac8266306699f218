// Sizes and numbers of quads asked of surfaces: met, or told where they are not.
#include "catch.h"
#include "shell/mesh_surface.h"
#include "support/meshed_surface.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("a surface gets about as many quads as are asked for") {
  const SurfaceMesh ring = torus(60, 30, 1, 0.4);
  for (const int quads : {300, 2000}) {
    const ShellOutcome outcome = meshed(soup_of(ring), {.quads = quads});
    CHECK(outcome.report.quality.quads == Approx(quads).epsilon(0.1));
    CHECK(outcome.report.warnings.empty());
  }
  const ShellOutcome bent = meshed(soup_of(ring), {.quads = 300, .turn = 12});
  REQUIRE(bent.report.warnings.size() == 1);  // no quad may be so large
  CHECK(bent.report.warnings.front().message.find("instead of 300") != std::string::npos);
  const auto both = mesh_surface(box_soup({1, 2, 1}, 3), {.size = 0.1, .quads = 50});
  REQUIRE_FALSE(both);
  CHECK(both.error().code == ErrorCode::bad_option);
}

TEST_CASE("sizes at points win over the size, and grow from there") {
  const SurfaceMesh pipe = cylinder(48, 60, 0.5, 4);
  SurfaceSoup soup = soup_of(pipe);
  soup.sizes.assign(soup.points.size(), 0);
  for (std::size_t p = 0; p < soup.points.size(); ++p)
    if (soup.points[p].z == 0) soup.sizes[p] = 0.05;
  const ShellOutcome outcome = meshed(soup, {.size = 0.2, .growth = 0.1});
  for (const auto& [a, b] : outcome.mesh.edges) {
    const Vec3 p = outcome.mesh.points[a], q = outcome.mesh.points[b];
    if (p.z != q.z) continue;
    const double asked = p.z == 0 ? 0.05 : 0.2;
    CHECK(distance(p, q) > 0.75 * asked);
    CHECK(distance(p, q) < 1.25 * asked);
  }
}

TEST_CASE("sizes inside a flat face, or at its border alone, are followed") {
  const auto quads = [](auto&& is_fine, double fine) {
    SurfaceSoup soup = soup_of(plane_square(10));
    soup.sizes.assign(soup.points.size(), 0);
    for (std::size_t p = 0; p < soup.points.size(); ++p)
      if (is_fine(soup.points[p])) soup.sizes[p] = fine;
    return meshed(soup, {.size = 0.1}).report.quality.quads;
  };
  const auto is_middle = [](Vec3 p) { return length(p - Vec3{0.5, 0.5, 0}) < 1e-9; };
  CHECK(quads(is_middle, 0.002) > 150);
  const auto is_border = [](Vec3 p) { return p.x * p.y == 0 || p.x == 1 || p.y == 1; };
  CHECK(quads(is_border, 0.01) < 5000);
}

TEST_CASE("sizes that are not taken are told of") {
  const auto said = [](const SurfaceSoup& soup, const SurfaceOptions& options, const char* words) {
    for (const Warning& warning : meshed(soup, options).report.warnings)
      if (warning.code == ErrorCode::adapted && warning.message.find(words) != std::string::npos)
        return true;
    return false;
  };
  const SurfaceSoup box = box_soup({1, 1, 1}, 2);
  CHECK(said(box, {.size = 25.4}, "larger than the whole surface"));
  CHECK_FALSE(said(box, {.size = 1}, "larger than the whole surface"));
  SurfaceSoup roofs;  // creases 1 apart
  constexpr Index ridges = 16;
  for (Index i = 0; i <= ridges; ++i)
    for (Index j = 0; j <= ridges; ++j)
      roofs.points.push_back({1.0 * i, 1.0 * j, i % 2 == 0 ? 0.0 : 1.0});
  for (Index i = 0; i < ridges; ++i)
    for (Index j = 0; j < ridges; ++j) {
      const Index corner = i * (ridges + 1) + j, next = corner + ridges + 1;
      roofs.triangles.push_back({corner, next, next + 1});
      roofs.triangles.push_back({corner, next + 1, corner + 1});
    }
  CHECK(said(roofs, {.size = 8}, "lies closer together"));
  CHECK_FALSE(said(roofs, {.size = 1}, "lies closer together"));
  CHECK_FALSE(said(box, {.size = 0.25}, "lies closer together"));
}

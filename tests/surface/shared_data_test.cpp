// Every surface of the shared data is read, and repaired where that is needed.
#include "catch.h"
#include "io/surface/obj_surface.h"
#include "support/surface_checks.h"
#include "support/surface_curves.h"
#include "support/surface_data.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

namespace {

RepairedSurface read_and_repair(const std::filesystem::path& path) {
  auto soup = read_obj_surface(read_bytes(path));
  REQUIRE(soup.has_value());
  const double area = area_of(soup->points, soup->triangles);
  auto surface = repair_surface(*std::move(soup));
  REQUIRE(surface.has_value());
  if (surface->report.duplicate_triangles == 0)
    CHECK(area_of(surface->mesh.points, surface->mesh.triangles) == Approx(area).epsilon(1e-9));
  return *std::move(surface);
}

/// A mesh size for so many quads.
double size_for(const SurfaceMesh& mesh, double quads) {
  return std::sqrt(area_of(mesh.points, mesh.triangles) / quads);
}

void check_curves_of(const SurfaceMesh& mesh) {
  for (const double quads : {300.0, 3000.0, 30000.0}) {
    const std::vector<double> size(mesh.points.size(), size_for(mesh, quads));
    const SurfaceFeatures features = find_features(mesh, size);
    const SurfaceCurves curves = trace_curves(mesh, features);
    check_curves(mesh, features, curves);
    const auto nodes = mesh_curves(mesh, features, curves, size);
    REQUIRE(nodes.has_value());
    check_curve_mesh(mesh, features, curves, *nodes);
  }
}

}  // namespace

TEST_CASE("valid surfaces of the shared data keep every triangle with a height", "[slow]") {
  for (const auto& path : shared_surfaces("surfaces")) {
    INFO(path.filename());
    const RepairedSurface surface = read_and_repair(path);
    check_surface(surface.mesh);
    CHECK(surface.report.flat_left == 0);
    CHECK(surface.report.turned_triangles == 0);
    CHECK(surface.report.conflict_edges == 0);
    check_curves_of(surface.mesh);
  }
}

TEST_CASE("defective surfaces of the shared data become surfaces with walls") {
  for (const auto& path : shared_surfaces("invalid_surfaces")) {
    INFO(path.filename());
    const RepairedSurface surface = read_and_repair(path);
    check_surface(surface.mesh);
    CHECK(surface.report.flat_left == 0);
    check_curves_of(surface.mesh);
  }
}

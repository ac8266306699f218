// Parts as CAD systems triangulate them. Of hundreds of faces every one is meshed, every edge kept.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "catch.h"
#include "pipeline/mesh_domain.h"
#include "shell/check.h"
#include "shell/mesh_surface.h"
#include "shell/topology.h"
#include "support/machined_part.h"
#include "support/surface_meshes.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// A rectangle and a round hole, in as few triangles as there are.
struct Plate {
  Loop outline{{3, 2}, {-3, 2}, {-3, -2}, {3, -2}}, hole;
  SurfaceSoup soup;

  Plate() {
    constexpr Index per_corner = 6, round = 4 * per_corner;
    for (Index k = 0; k < round; ++k) {
      const double angle = turn * k / round;
      hole.push_back({0.5 + 0.8 * std::cos(angle), 0.3 + 0.8 * std::sin(angle)});
    }
    for (const Loop& loop : {outline, hole})
      for (const Vec2 p : loop) soup.points.push_back({p.x, p.y, 0});
    const auto at_hole = [](Index k) { return 4 + k % round; };
    for (Index corner = 0; corner < 4; ++corner) {
      const Index first = per_corner * corner, last = first + per_corner;
      for (Index k = first; k < last; ++k)
        soup.triangles.push_back({corner, at_hole(k + 1), at_hole(k)});
      soup.triangles.push_back({corner, (corner + 1) % 4, at_hole(last)});
    }
    soup.group_names = {""};
  }
};

}  // namespace

// The surface's own field knows one direction for each of these triangles.
TEST_CASE("a plate in few triangles is meshed as well as in the plane", "[slow]") {
  constexpr double h = 0.08;
  const Plate plate;
  SurfaceOptions options;
  options.size = h;
  const auto outcome = mesh_surface(plate.soup, options);
  REQUIRE(outcome.has_value());
  DomainInput domain;
  domain.regions.push_back({"", {plate.outline, plate.hole}, {}});
  UserFields alone;  // no other size is tried for it, nor a grid
  alone.size = [](Vec2) { return h; };
  const auto in_plane = mesh_domain(domain, {.size = h}, {}, nullptr, alone);
  REQUIRE(in_plane.has_value());
  const auto lacking = [](const auto& quality) {
    return (1 - quality.eta_mean) + (1 - quality.four_valent_percent / 100);
  };
  CAPTURE(lacking(outcome->report.quality), lacking(in_plane->report.quality));
  CHECK(lacking(outcome->report.quality) < 1.05 * lacking(in_plane->report.quality));
}

TEST_CASE("a machined part of more than 250 faces gets quads only, all of its edges kept",
          "[slow]") {
  const SurfaceSoup part = MachinedPart::make(6, 4, 16);
  const SurfaceMesh surface = repair_surface(part)->mesh;
  SurfaceOptions options;
  options.size = std::sqrt(surface_area(surface) / 10000);
  const auto outcome = mesh_surface(part, options);
  REQUIRE(outcome.has_value());
  const ShellReport& report = outcome->report;
  CHECK(report.faces >= 250);
  CHECK(report.faces == static_cast<Index>(part.group_names.size()));
  CHECK(report.repair.border_edges == 0);
  CHECK(check_shell(outcome->surface, outcome->mesh).empty());
  CHECK(report.quality.triangles == 0);
  CHECK(report.quality.nonconvex == 0);
  CHECK(report.quality.eta_min > 0.1);
  CHECK(report.quality.eta_mean > 0.89);
  CHECK(report.quality.four_valent_percent > 90);

  const ShellTopology topology = shell_topology(outcome->mesh.faces);
  CHECK(topology.components == 1);
  CHECK(topology.euler == euler(surface));
  // Holes: a cell has a boss with a hole, a counterbore, a slot, or nothing that goes through.
  CHECK(topology.euler == 2 - 2 * 15);
  CHECK(std::set<Index>(outcome->mesh.face.begin(), outcome->mesh.face.end()).size() ==
        part.group_names.size());

  const SurfaceFeatures features =
      find_features(surface, std::vector<double>(surface.points.size(), options.size));
  double there = 0, here = 0;
  for (const auto& [a, b] : outcome->mesh.edges)
    here += distance(outcome->mesh.points[a], outcome->mesh.points[b]);
  for (Index e = 0; e < static_cast<Index>(surface.twins.size()); ++e)
    if (features.half_edge_is_feature(e))
      there += 0.5 * distance(surface.points[surface.origin(e)], surface.points[surface.target(e)]);
  CHECK(here < there);
  CHECK(here > 0.97 * there);  // of chords
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    if (features.corner[v])
      CHECK(std::count(outcome->mesh.points.begin(), outcome->mesh.points.end(),
                       surface.points[v]) == 1);
}

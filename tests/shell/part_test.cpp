// A machined part of hundreds of faces: every one meshed, every edge kept.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "catch.h"
#include "shell/check.h"
#include "shell/mesh_surface.h"
#include "shell/topology.h"
#include "support/machined_part.h"
#include "support/surface_meshes.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

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

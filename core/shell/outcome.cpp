// See outcome.h.
#include "shell/outcome.h"

#include <algorithm>

#include "base/hash.h"
#include "shell/outcome_warnings.h"
#include "shell/place.h"
#include "shell/quality.h"
#include "shell/topology.h"
#include "surface/curves.h"

namespace lpq {
namespace {

void count_lines(const SurfaceFeatures& features, const SurfaceMesh& surface, ShellReport& report) {
  for (Index edge = 0; edge < features.edges.count(); ++edge)
    report.feature_edges += features.is_feature(edge);
  report.corners =
      static_cast<Index>(std::count(features.corner.begin(), features.corner.end(), 1));
  report.curves = trace_curves(surface, features).count();
  report.faces = features.face_count;
}

std::vector<Index> groups_of_faces(const SurfaceFeatures& features, const SurfaceMesh& surface) {
  constexpr Index unseen = -2;
  std::vector<Index> groups(features.face_count, unseen);
  for (Index t = 0; t < surface.triangle_count(); ++t) {
    Index& group = groups[features.face[t]];
    if (group == unseen) group = surface.group[t];
    if (group != surface.group[t]) group = none;
  }
  return groups;
}

std::vector<BodyReport> reports_of_bodies(const ShellOutcome& outcome) {
  const ShellMesh& mesh = outcome.mesh;
  std::vector<BodyReport> reports;
  for (const std::string& name : outcome.body_names) reports.emplace_back().name = name;
  if (reports.empty()) return reports;
  const std::vector<Index> body = bodies_at(outcome.surface, mesh.places);
  std::vector<Index> number;  // #V  in its body: what a count costs must not grow with the others
  for (const Index b : body) number.push_back(reports[b].vertices++);
  std::vector<std::vector<Face>> faces(reports.size());
  for (Face face : mesh.faces) {
    const Index b = body[face[0]];
    ++(face[3] == none ? reports[b].triangles : reports[b].quads);
    for (Index& v : face)
      if (v != none) v = number[v];
    faces[b].push_back(face);
  }
  for (std::size_t b = 0; b < reports.size(); ++b) {
    const ShellTopology topology = shell_topology(faces[b]);
    reports[b].parts = topology.components;
    reports[b].border_edges = topology.border_edges;
  }
  return reports;
}

std::uint64_t hash_of(const ShellMesh& mesh) {
  Fnv1a hash;
  hash.add(std::span<const Vec3>(mesh.points));
  hash.add(std::span<const Face>(mesh.faces));
  return hash.value();
}

}  // namespace

void summarise(const SurfaceFeatures& features, const SurfaceCrossField& cross,
               std::span<const double> size, ShellOutcome& outcome) {
  const SurfaceMesh& surface = outcome.surface;
  ShellReport& report = outcome.report;
  count_lines(features, surface, report);
  outcome.face_group = groups_of_faces(features, surface);
  report.charts = static_cast<Index>(outcome.atlas.charts.size());
  report.singularities = cross.singularities;
  report.quality = shell_quality(outcome.mesh);
  report.size = shell_size_fidelity(outcome.mesh, surface.triangles, size);
  report.distance = surface_distance(surface.points, surface.triangles, outcome.mesh);
  report.bodies = reports_of_bodies(outcome);
  report.hash = hash_of(outcome.mesh);
  warn_of_outcome(features, size, outcome);
}

}  // namespace lpq

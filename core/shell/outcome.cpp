// See outcome.h.
#include "shell/outcome.h"

#include <algorithm>

#include "base/function_ref.h"
#include "base/hash.h"
#include "base/words.h"
#include "shell/crossings.h"
#include "shell/place.h"
#include "shell/quality.h"
#include "shell/shape/descent.h"
#include "shell/shape/short_sides.h"
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

Warning bent_quads(const ShellMesh& mesh, Index count) {
  const Vec3 at = mesh.points[mesh.faces[first_nonconvex(mesh)][0]];
  return {ErrorCode::no_valid_mesh,
          "Not all quads are convex: " + std::to_string(count) + ", the first near " +
              place_in_space(at.x, at.y, at.z) + ". A smaller size may help.",
          {}};
}

/// Told of quads for which `is_bad` holds.
void warn_of_quads(ShellOutcome& outcome, const std::string& what,
                   FunctionRef<bool(Index)> is_bad) {
  Index count = 0, first = none;
  for (Index f = 0; f < static_cast<Index>(outcome.mesh.faces.size()); ++f)
    if (corner_count(outcome.mesh.faces[f]) == 4 && is_bad(f) && count++ == 0) first = f;
  if (count == 0) return;
  const Vec3 at = outcome.mesh.points[outcome.mesh.faces[first][0]];
  outcome.report.warnings.push_back(
      {ErrorCode::bad_size,
       "Quads with " + what + ": " + std::to_string(count) + ", the first near " +
           place_in_space(at.x, at.y, at.z) +
           ". The surface has a strip or a fold there that is narrow for the size. Mend it, or use "
           "a smaller size.",
       {}});
}

/// Of narrow strips and folds of the surface, mostly.
void warn_of_thin_quads(ShellOutcome& outcome) {
  constexpr double thin = 0.02, vanished = 0.01;  // eta; of the longest side
  const ShellMesh& mesh = outcome.mesh;
  const auto is_thin = [&](Index f) {
    const auto [a, b, c, d] = corners_of(mesh, f);
    return quad_eta(a, b, c, d) < thin && !has_reflex_corner(a, b, c, d);
  };
  warn_of_quads(outcome, "hardly any area (eta below " + short_number(thin) + ")", is_thin);
  warn_of_quads(outcome, "a side shorter than " + short_number(vanished) + " of the longest",
                [&](Index f) { return has_short_side(mesh, f, vanished) && !is_thin(f); });
}

Index nearest_vertex(const ShellMesh& mesh, Vec3 p) {
  Index nearest = 0;
  for (Index v = 1; v < static_cast<Index>(mesh.points.size()); ++v)
    if (distance(mesh.points[v], p) < distance(mesh.points[nearest], p)) nearest = v;
  return nearest;
}

/// Where the mesh cuts off more of the surface than a good quad does, or stands out from it.
void warn_of_distance(std::span<const double> size, ShellOutcome& outcome) {
  constexpr double most = 0.5;  // of the size there
  const auto& [to_surface, from_surface] = outcome.report.distance;
  const bool stands_out = to_surface.max > from_surface.max;
  const auto& [max, mean, at] = stands_out ? to_surface : from_surface;
  const SurfacePlace& place = outcome.mesh.places[nearest_vertex(outcome.mesh, at)];
  const double h = size_at(outcome.surface.triangles, place, size);
  if (max <= most * h) return;
  outcome.report.warnings.push_back(
      {ErrorCode::bad_size,
       (stands_out ? "Quads stand out from what is small for their size: up to " +
                         short_number(max) + " from the surface near "
                   : "The mesh cuts off what is small for its size: the surface goes " +
                         short_number(max) + " from it near ") +
           place_in_space(at.x, at.y, at.z) + ", where the size is " + short_number(h) +
           ". Use a smaller size.",
       {}});
}

/// Where features, borders or sheets beside each other have asked for much smaller quads.
void warn_of_smaller_sizes(ShellOutcome& outcome) {
  constexpr double much_smaller = 0.5;
  ShellReport& report = outcome.report;
  if (report.feature_edges == 0 || report.size.p50 >= much_smaller) return;
  report.warnings.push_back({ErrorCode::adapted,
                             "Half of the edges are shorter than " + short_number(report.size.p50) +
                                 " of the size asked for: what has to be kept lies closer "
                                 "together. With a larger feature "
                                 "angle fewer edges are kept.",
                             {}});
}

/// "Bodies 0 (bolt) and 2", as given.
std::string bodies_text(const ShellOutcome& outcome, Index s, Index t) {
  const auto name = [&](Index triangle) {
    const Index body = outcome.surface.body_of(outcome.surface.triangles[triangle][0]);
    const std::string& label = outcome.body_names[static_cast<std::size_t>(body)];
    return std::to_string(body) + (label.empty() ? "" : " (" + label + ")");
  };
  return "Bodies " + name(s) + " and " + name(t);
}

/// Of bodies that go into each other, and of a surface that goes through itself where no pair of
/// quads tells it.
void warn_of_given_crossings(std::span<const double> size, bool told, ShellOutcome& outcome) {
  const auto [within, between] = given_crossings(outcome.surface, size);
  const auto warn = [&](const std::string& what, const std::vector<FaceCrossing>& crossings,
                        const char* then) {
    const Vec3 at = crossings[0].at;
    outcome.report.warnings.push_back({ErrorCode::self_intersection,
                                       what + ": " + std::to_string(crossings.size()) +
                                           " pairs of triangles, the first near " +
                                           place_in_space(at.x, at.y, at.z) + then,
                                       {}});
  };
  if (!between.empty()) {
    const auto [s, t] = between[0].faces;
    warn(bodies_text(outcome, s, t) + " go through each other", between,
         ". Each gets a mesh of its own, as if it were alone: unite them, or part them.");
  }
  if (!within.empty() && !told)
    warn("The surface goes through itself", within,
         ". The mesh may not be what is meant there: repair the surface.");
}

/// The place is one of the mesh alone, if there is any. False if nothing is told.
bool warn_of_crossings(ShellOutcome& outcome) {
  const std::vector<FaceCrossing> crossings = mesh_crossings(outcome.surface, outcome.mesh);
  if (crossings.empty()) return false;
  const FaceCrossing* first = &crossings[0];
  for (const FaceCrossing& crossing : crossings)
    if (first->given && !crossing.given) first = &crossing;
  outcome.report.warnings.push_back(
      {ErrorCode::no_valid_mesh,
       "Pairs of quads that go through each other: " + std::to_string(crossings.size()) +
           ", the first near " + place_in_space(first->at.x, first->at.y, first->at.z) +
           (first->given ? ". The surface goes through itself there: repair it."
                         : ". Use a smaller size there, or repair the surface."),
       {}});
  return true;
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
  warn_of_distance(size, outcome);
  warn_of_smaller_sizes(outcome);
  warn_of_thin_quads(outcome);
  warn_of_given_crossings(size, warn_of_crossings(outcome), outcome);
  if (report.quality.nonconvex > 0)
    report.warnings.push_back(bent_quads(outcome.mesh, report.quality.nonconvex));
}

}  // namespace lpq

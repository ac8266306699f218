// See outcome_warnings.h.
#include "shell/outcome_warnings.h"

#include <string>

#include "base/function_ref.h"
#include "base/words.h"
#include "shell/crossings.h"
#include "shell/place.h"
#include "shell/quality.h"
#include "shell/shape/descent.h"
#include "shell/shape/outside.h"
#include "shell/shape/short_sides.h"
#include "shell/topology.h"

namespace lpq {
namespace {

/// `first` of `count` quads.
void warn_of_quads(ShellOutcome& outcome, ErrorCode code, const std::string& what,
                   const std::string& remedy, Index count, Index first) {
  if (count == 0) return;
  const Vec3 at = outcome.mesh.points[outcome.mesh.faces[first][0]];
  outcome.report.warnings.push_back({code,
                                     what + ": " + std::to_string(count) + ", the first near " +
                                         place_in_space(at.x, at.y, at.z) + ". " + remedy,
                                     {}});
}

/// Told of quads for which `is_bad` holds.
void warn_of_quads(ShellOutcome& outcome, ErrorCode code, const std::string& what,
                   const std::string& remedy, FunctionRef<bool(Index)> is_bad) {
  Index count = 0, first = none;
  for (Index f = 0; f < static_cast<Index>(outcome.mesh.faces.size()); ++f)
    if (corner_count(outcome.mesh.faces[f]) == 4 && is_bad(f) && count++ == 0) first = f;
  warn_of_quads(outcome, code, what, remedy, count, first);
}

/// Of narrow strips and folds of the surface, mostly.
void warn_of_thin_quads(ShellOutcome& outcome) {
  constexpr double thin = 0.02, vanished = 0.01;  // eta; of the longest side
  const ShellMesh& mesh = outcome.mesh;
  const auto is_thin = [&](Index f) {
    const auto [a, b, c, d] = corners_of(mesh, f);
    return quad_eta(a, b, c, d) < thin && !has_reflex_corner(a, b, c, d);
  };
  const std::string remedy =
      "The surface has a strip or a fold there that is narrow for the size. Mend it, or use a "
      "smaller size.";
  warn_of_quads(outcome, ErrorCode::bad_size,
                "Quads with hardly any area (eta below " + short_number(thin) + ")", remedy,
                is_thin);
  warn_of_quads(outcome, ErrorCode::bad_size,
                "Quads with a side shorter than " + short_number(vanished) + " of the longest",
                remedy, [&](Index f) { return has_short_side(mesh, f, vanished) && !is_thin(f); });
}

/// By the quad's own normal, then by the surface's: one that lies turned over may be a good quad.
void warn_of_bent_quads(const SurfaceFeatures& features, std::span<const double> size,
                        ShellOutcome& outcome) {
  const ShellMesh& mesh = outcome.mesh;
  warn_of_quads(outcome, ErrorCode::no_valid_mesh, "Not all quads are convex",
                "A smaller size may help.", [&](Index f) {
                  const auto [a, b, c, d] = corners_of(mesh, f);
                  return has_reflex_corner(a, b, c, d);
                });
  const std::vector<Index> turned = Outside(outcome.surface, features, size).turned_quads(mesh);
  warn_of_quads(outcome, ErrorCode::no_valid_mesh, "Quads that look against the surface",
                "The mesh folds over itself there, where the surface is thin or bends within a "
                "quad. Use a smaller size there, or repair the surface.",
                static_cast<Index>(turned.size()), turned.empty() ? none : turned[0]);
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

void warn_of_outcome(const SurfaceFeatures& features, std::span<const double> size,
                     ShellOutcome& outcome) {
  warn_of_distance(size, outcome);
  warn_of_smaller_sizes(outcome);
  warn_of_thin_quads(outcome);
  warn_of_given_crossings(size, warn_of_crossings(outcome), outcome);
  warn_of_bent_quads(features, size, outcome);
}

}  // namespace lpq

#include "pipeline/finish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/function_ref.h"
#include "base/hash.h"
#include "base/option_table.h"
#include "base/words.h"
#include "geometry/box.h"
#include "geometry/segment.h"
#include "mesh/quality.h"

namespace lpq {
namespace {

// New number of every vertex: nodes by their rank in the caller's order, then used free vertices.
std::vector<Index> output_numbers(const QuadMesh& mesh, const BoundaryMesh& boundary) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Face& face : mesh.faces)
    for (int k = 0; k < corner_count(face); ++k) used[face[k]] = 1;
  std::vector<Index> number(mesh.points.size(), none);
  Index next = mesh.fixed;
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v)
    if (v < mesh.fixed)
      number[v] = boundary.output_rank[v];
    else if (used[v])
      number[v] = next++;
  return number;
}

std::vector<OutputEdge> output_edges(const BoundaryMesh& boundary) {
  std::vector<OutputEdge> edges;
  edges.reserve(boundary.edges.size());
  for (const Segment& s : boundary.edges)
    edges.push_back({boundary.output_rank[s.a], boundary.output_rank[s.b], s.left, s.right, s.tag,
                     s.region, s.loop, s.edge});
  return edges;
}

/// Between the two boundary points nearest to a place, if that is next to nothing; else 0.
double gap_at(const OutputMesh& mesh, Vec2 place) {
  constexpr double nothing = 1e-12;  // of the extent
  if (mesh.fixed < 2) return 0;
  const auto before = [place](Vec2 p, Vec2 q) {
    const double by = squared_length(p - place) - squared_length(q - place);
    return by != 0 ? by < 0 : p < q;
  };
  Vec2 first = mesh.points[0], second = mesh.points[1];  // the two nearest
  if (before(second, first)) std::swap(first, second);
  for (Index v = 2; v < mesh.fixed; ++v) {
    if (!before(mesh.points[v], second)) continue;
    second = mesh.points[v];
    if (before(second, first)) std::swap(first, second);
  }
  const double gap = distance(first, second);
  return gap < nothing * longer_side(box_of(mesh.points)) ? gap : 0;
}

/// Longer than the quads around are by far. Cost O(#E + #F).
bool is_beside_long_edge(const OutputMesh& mesh, Vec2 place) {
  constexpr double far = 3;
  double nearest = HUGE_VAL, edge = 0;
  for (const OutputEdge& e : mesh.edges) {
    const Vec2 a = mesh.points[e.a], b = mesh.points[e.b];
    const double away = squared_length(closest_point(place, a, b) - place);
    if (away < nearest) nearest = away, edge = distance(a, b);
  }
  std::vector<double> sides;  // of faces no farther than the edge is long
  for (const Face& face : mesh.faces) {
    if (!(distance(centre_of(mesh.points, face), place) < edge)) continue;
    for (int k = 0, n = corner_count(face); k < n; ++k)
      sides.push_back(distance(mesh.points[face[k]], mesh.points[face[(k + 1) % n]]));
  }
  if (sides.empty()) return false;
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  std::nth_element(sides.begin(), middle, sides.end());
  return edge > far * *middle;
}

bool has_short_side(const std::vector<Vec2>& points, const Face& quad, double share) {
  double least = HUGE_VAL, greatest = 0;
  for (int k = 0; k < 4; ++k) {
    const double side = squared_length(points[quad[k]] - points[quad[(k + 1) % 4]]);
    least = std::min(least, side);
    greatest = std::max(greatest, side);
  }
  return least < share * share * greatest;
}

void tell_quads(const OutputMesh& mesh, const std::string& what,
                FunctionRef<bool(const Face&)> is_poor, std::vector<Warning>& warnings) {
  Index count = 0;
  Vec2 first;
  for (const Face& face : mesh.faces)
    if (corner_count(face) == 4 && is_poor(face) && count++ == 0)
      first = centre_of(mesh.points, face);
  if (count == 0) return;
  warnings.push_back({ErrorCode::bad_size,
                      "Quads with " + what + ": " + std::to_string(count) +
                          (is_beside_long_edge(mesh, first)
                               ? ". The first lies beside an edge of the boundary that is long for "
                                 "the size. Divide it, let the boundary be refined instead of "
                                 "kept, or use a larger size."
                               : ". The first has an angle or an edge of the boundary beside it "
                                 "that is small for the size. Mend it, or use a smaller size."),
                      {}});
  warnings.back().where.set_point(first.x, first.y);
}

}  // namespace

OutputMesh to_output(const QuadMesh& mesh, const Domain& domain, const BoundaryMesh& boundary) {
  const std::vector<Index> number = output_numbers(mesh, boundary);
  OutputMesh out;
  out.fixed = mesh.fixed;
  out.regions = domain.regions;
  out.tags = domain.tags;
  out.edges = output_edges(boundary);
  out.region = mesh.region;

  const Index count = std::max(
      mesh.fixed, number.empty() ? 0 : *std::max_element(number.begin(), number.end()) + 1);
  out.points.resize(static_cast<std::size_t>(count));
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()); ++v)
    if (number[v] != none)
      out.points[number[v]] =
          v < mesh.fixed ? boundary.world[v] : domain.frame.to_world(mesh.points[v]);

  out.faces.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    Face renumbered = face;
    for (int k = 0; k < corner_count(face); ++k) renumbered[k] = number[face[k]];
    out.faces.push_back(renumbered);
  }
  for (Index v = 0; v < mesh.fixed; ++v)
    if (const Index source = boundary.source[v]; source != none && domain.point_tag[source] != none)
      out.tagged_points.push_back({number[v], domain.point_tag[source]});
  return out;
}

std::vector<Violation> check_output(const OutputMesh& mesh) {
  QuadMesh plain;
  plain.points = mesh.points;
  plain.faces = mesh.faces;
  plain.region = mesh.region;
  plain.fixed = mesh.fixed;
  std::vector<std::array<Index, 2>> outline;
  for (const OutputEdge& e : mesh.edges) {
    if (e.left != none && e.right == none) outline.push_back({e.a, e.b});
    if (e.left == none && e.right != none) outline.push_back({e.b, e.a});
    if (e.left != none && e.right != none)
      plain.walls.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
  }
  std::sort(plain.walls.begin(), plain.walls.end());
  return validate(plain, {outline});
}

Error no_valid_mesh(const OutputMesh& mesh, const std::vector<Violation>& violations) {
  const Violation& first = violations.front();
  Error error;
  error.where.set_point(first.point.x, first.point.y);
  if (const double gap = gap_at(mesh, first.point); gap > 0) {
    error.code = ErrorCode::touching;
    error.message = "Two points of the boundary lie " + short_number(gap) +
                    " apart, nearer than quads can be told from each other. Make them one point "
                    "where the lines may meet, or move them apart.";
    return error;
  }
  error.code = ErrorCode::no_valid_mesh;
  error.message = "No valid mesh was found: " + first.what + " Try a " +
                  (is_beside_long_edge(mesh, first.point) ? "larger" : "smaller") +
                  " size, or let the boundary be refined instead of kept.";
  return error;
}

std::vector<Warning> tell_triangles(const OutputMesh& mesh) {
  std::vector<Warning> warnings;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    if (corner_count(face) != 3) continue;
    const Vec2 centre = centre_of(mesh.points, face);
    Warning warning;
    warning.code = ErrorCode::odd_boundary;
    warning.message =
        "The number of boundary edges is odd, so one triangle was left here, of eta " +
        short_number(face_eta(mesh.points, face)) + ".";
    warning.where.region = mesh.region[f];
    warning.where.set_point(centre.x, centre.y);
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

std::vector<Warning> tell_poor_quads(const OutputMesh& mesh) {
  constexpr double thin = 0.01, vanished = 0.01;  // eta; of the longest side
  std::vector<Warning> warnings;
  const auto is_thin = [&](const Face& face) { return face_eta(mesh.points, face) < thin; };
  tell_quads(mesh,
             "a corner that is all but straight or closed (eta below " + short_number(thin) + ")",
             is_thin, warnings);
  // eta sees angles only
  const auto is_short = [&](const Face& face) {
    return !is_thin(face) && has_short_side(mesh.points, face, vanished);
  };
  tell_quads(mesh, "a side shorter than " + short_number(vanished) + " of the longest", is_short,
             warnings);
  return warnings;
}

SizeFidelity size_fidelity(const QuadMesh& mesh, const Fields& fields) {
  std::vector<double> ratios;
  ratios.reserve(mesh.faces.size() * 4);
  Index hint = none;
  for (const Face& face : mesh.faces) {
    const int corners = corner_count(face);
    for (int k = 0; k < corners; ++k) {
      const Vec2 a = mesh.points[face[k]], b = mesh.points[face[(k + 1) % corners]];
      ratios.push_back(length(b - a) / fields.size(midpoint(a, b), hint));
    }
  }
  return size_fidelity(std::move(ratios));
}

std::uint64_t output_hash(const OutputMesh& mesh) {
  Fnv1a hash;
  hash.add(std::span<const Vec2>(mesh.points));
  hash.add(std::span<const Face>(mesh.faces));
  return hash.value();
}

}  // namespace lpq

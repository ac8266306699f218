// See outside.h.
#include "shell/shape/outside.h"

#include <algorithm>

#include "mesh/neighbours.h"
#include "surface/frames.h"
#include "surface/normals.h"

namespace lpq {
namespace {

// Flatness above which the normals at the corners say whether a quad is turned.
constexpr double flat_enough = 0.9;
// Weights in triangles below are taken for zero.
constexpr double on_side = 1e-9;

/// How fast a way from a place on the border of a triangle leads inside: over the sides that the
/// place is on, the least speed away from them.
double least_inward(const SurfaceMesh& mesh, const SurfacePlace& place, Vec3 way) {
  const TriangleLayout layout = layout_of(mesh, place.triangle);
  const TriangleAxes axes = axes_of(mesh, place.triangle);
  const Vec2 flat{dot(way, axes.x), dot(way, axes.y)};
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec2 side = layout.side[(k + 1) % 3];
    const double size = length(side);
    if (place.weight[k] == 0 && size > 0) least = std::min(least, cross(side, flat) / size);
  }
  return least;
}

/// Of a quad, with twice its area for length.
Vec3 normal_of(const ShellMesh& mesh, Index f) {
  const auto [a, b, c, d] = mesh.faces[f];
  return cross(mesh.points[c] - mesh.points[a], mesh.points[d] - mesh.points[b]);
}

/// Where in the triangle p, a point of it, lies.
SurfacePlace place_in(const SurfaceMesh& mesh, Index triangle, Vec3 p) {
  const Tri& t = mesh.triangles[triangle];
  const auto at = [&](int k) { return mesh.points[t[k % 3]]; };
  const Vec3 normal = cross(at(1) - at(0), at(2) - at(0));
  const double whole = squared_length(normal);
  SurfacePlace place{triangle, {1, 0, 0}};
  for (int k = 0; k < 3 && whole > 0; ++k) {
    const double weight = dot(cross(at(k + 2) - at(k + 1), p - at(k + 1)), normal) / whole;
    place.weight[k] = weight < on_side ? 0 : weight;
  }
  return place;
}

}  // namespace

Outside::Outside(const SurfaceMesh& surface, const SurfaceFeatures& features,
                 std::span<const double> size)
    : surface_(surface),
      features_(features),
      normal_(triangle_normals(surface, size)),
      triangles_(triangles_at_vertices(surface.triangles, surface.vertex_count())),
      nearest_(surface.points, surface.triangles) {}

/// One for a place inside a triangle, those beside an edge, those around a vertex.
template <class Visit>
void Outside::for_each_triangle_at(const SurfacePlace& place, Visit&& visit) const {
  int zeros = 0;
  Index zero = 0, other = 0;
  for (Index k = 0; k < 3; ++k) {
    const bool none_of_it = place.weight[k] == 0;
    zeros += none_of_it;
    (none_of_it ? zero : other) = k;
  }
  if (zeros == 0) {
    visit(place.triangle);
  } else if (zeros == 1) {
    const Index edge = features_.edges.edge_of[3 * place.triangle + next_in_triangle(zero)];
    for (const Index e : features_.edges.half_edges.row(edge)) visit(triangle_of(e));
  } else {
    for (const Index t : triangles_.row(surface_.triangles[place.triangle][other])) visit(t);
  }
}

Vec3 Outside::mean_normal(const ShellMesh& mesh, Index f) const {
  Vec3 sum{};
  int count = 0;
  for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
    for_each_triangle_at(mesh.places[mesh.faces[f][k]], [&](Index t) {
      if (features_.face[t] != mesh.face[f]) return;
      sum += normal_[t];
      ++count;
    });
  return count > 0 ? (1.0 / count) * sum : sum;
}

Vec3 Outside::at(const ShellMesh& mesh, Index f) const {
  const Vec3 mean = mean_normal(mesh, f);
  const double size = length(mean);
  return size > 0 ? (1 / size) * mean : Vec3{};
}

double Outside::flatness(const ShellMesh& mesh, Index f) const {
  return length(mean_normal(mesh, f));
}

bool Outside::is_turned(const ShellMesh& mesh, Index f) const {
  if (mesh.faces[f][3] == none) return false;
  const Vec3 mean = mean_normal(mesh, f);
  if (length(mean) > flat_enough) return dot(normal_of(mesh, f), mean) < 0;
  return looks_away(mesh, f, {nearest_});
}

std::vector<Index> Outside::turned_quads(const ShellMesh& mesh) const {
  std::vector<Index> turned, result;
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f)
    if (is_turned(mesh, f)) turned.push_back(f);
  if (turned.empty()) return result;
  const Csr<Index> quads = csr_from<Index>(features_.face_count, [&](auto&& emit) {
    for (const Index f : turned) emit(mesh.face[f], f);
  });
  const Csr<Index> triangles = members_of(features_.face, features_.face_count);
  for (Index face = 0; face < quads.rows(); ++face) {
    if (quads.row(face).empty()) continue;
    std::vector<Tri> own;
    for (const Index t : triangles.row(face)) own.push_back(surface_.triangles[t]);
    const NearestTriangle nearest(surface_.points, own);
    for (const Index f : quads.row(face))
      if (looks_away(mesh, f, {nearest, triangles.row(face)})) result.push_back(f);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// At most of five points of the quad.
bool Outside::looks_away(const ShellMesh& mesh, Index f, const Sheet& sheet) const {
  const Face& face = mesh.faces[f];
  const auto corner = [&](int k) { return mesh.points[face[k]]; };
  const auto hint = [&](int k) {
    return sheet.triangles.empty() ? mesh.places[face[k]].triangle : 0;
  };
  const Vec3 normal = normal_of(mesh, f);
  const Vec3 middle = 0.25 * (corner(0) + corner(1) + corner(2) + corner(3));
  int away = looks_away(middle, normal, hint(0), sheet);
  for (int k = 0; k < 4; ++k)
    away += looks_away(0.75 * corner(k) + 0.25 * middle, normal, hint(k), sheet);
  return away > 2;
}

/// No triangle where the sheet is nearest to p looks the way of this normal.
bool Outside::looks_away(Vec3 p, Vec3 normal, Index hint, const Sheet& sheet) const {
  const NearestTriangle::Hit hit = sheet.nearest.find(p, hint);
  const Index nearest = sheet.triangles.empty() ? hit.triangle : sheet.triangles[hit.triangle];
  bool away = true;
  for_each_triangle_at(place_in(surface_, nearest, hit.point),
                       [&](Index t) { away = away && dot(normal_[t], normal) <= 0; });
  return away;
}

SurfacePlace Outside::on_side(const SurfacePlace& place, Index face, Vec3 way) const {
  SurfacePlace best = place;
  double most = -1e300;
  for_each_triangle_at(place, [&](Index t) {
    if (features_.face[t] != face) return;
    SurfacePlace here{t, {0, 0, 0}};
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        if (surface_.triangles[t][k] == surface_.triangles[place.triangle][j])
          here.weight[k] = place.weight[j];
    const double depth = least_inward(surface_, here, way);
    if (depth > most) {
      most = depth;
      best = here;
    }
  });
  return best;
}

}  // namespace lpq

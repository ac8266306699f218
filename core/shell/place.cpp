// See place.h.
#include "shell/place.h"

#include <algorithm>
#include <limits>

#include "geometry/box.h"
#include "geometry/segment.h"
#include "surface/weld.h"

namespace lpq {
namespace {

/// p itself in the triangle, else the point nearest to it.
Vec2 nearest_in(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  const Vec2 corner[4] = {a, b, c, a};
  Vec2 best = p;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vec2 from = corner[k], along = corner[k + 1] - from;
    if (cross(along, p - from) >= 0) continue;
    const Vec2 q = from + share_along(p, from, corner[k + 1]) * along;
    if (squared_length(p - q) >= best_distance) continue;
    best_distance = squared_length(p - q);
    best = q;
  }
  return best;
}

}  // namespace

SurfacePlace place_on(const Chart& chart, const Fields& fields, Vec2 p, Index& hint) {
  const Index t = fields.locator.find_nearest(p, hint);
  const auto [i, j, k] = chart.plane.triangles[t];
  const Vec2 a = chart.plane.points[i], b = chart.plane.points[j], c = chart.plane.points[k];
  const double area = cross(b - a, c - a);
  if (!(area > 0)) return {chart.triangles[t], {1.0 / 3, 1.0 / 3, 1.0 / 3}};  // a plane that failed
  const Vec2 q = nearest_in(a, b, c, p);
  const double wa = std::clamp(cross(c - b, q - b) / area, 0.0, 1.0);
  const double wb = std::clamp(cross(a - c, q - c) / area, 0.0, 1.0 - wa);
  return {chart.triangles[t], {wa, wb, 1 - wa - wb}};
}

Vec3 point_at(const SurfaceMesh& mesh, const SurfacePlace& place) {
  const Tri& corners = mesh.triangles[place.triangle];
  Vec3 p{};
  for (int k = 0; k < 3; ++k) p += place.weight[k] * mesh.points[corners[k]];
  return p;
}

double size_at(std::span<const Tri> triangles, const SurfacePlace& place,
               std::span<const double> size) {
  double h = 0;
  for (int k = 0; k < 3; ++k) h += place.weight[k] * size[triangles[place.triangle][k]];
  return h;
}

std::vector<Index> bodies_at(const SurfaceMesh& mesh, std::span<const SurfacePlace> places) {
  std::vector<Index> bodies;
  if (mesh.body.empty()) return bodies;
  for (const SurfacePlace& place : places)
    bodies.push_back(mesh.body[mesh.triangles[place.triangle][0]]);
  return bodies;
}

void part_vertices(const SurfaceMesh& mesh, ShellMesh& shell, const Parting& parting) {
  const double reach = parting.one_point * bounding_diagonal(mesh.points);
  const std::vector<char> all(shell.points.size(), 1);
  const std::vector<Index> first =
      weld_points(shell.points, all, reach, bodies_at(mesh, shell.places));
  // Every further one in a place goes further, or those of one triangle would stay together.
  std::vector<Index> moved(first.size(), 0);
  const auto move = [&](Index v, Index place_of) {
    SurfacePlace& place = shell.places[v];
    for (Index step = ++moved[place_of]; step > 0; --step)
      for (double& weight : place.weight) weight += parting.inward * (1.0 / 3 - weight);
    shell.points[v] = point_at(mesh, place);
  };
  for (Index v = 0; v < static_cast<Index>(first.size()); ++v) {
    if (first[v] == v) continue;
    if (shell.is_free(v))
      move(v, first[v]);
    else if (shell.is_free(first[v]))
      move(first[v], first[v]);
  }
}

}  // namespace lpq

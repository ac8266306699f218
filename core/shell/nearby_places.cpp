// See nearby_places.h.
#include "shell/nearby_places.h"

#include <algorithm>

#include "mesh/neighbours.h"
#include "shell/nearest_triangle.h"

namespace lpq {

NearbyPlaces::NearbyPlaces(const SurfaceMesh& mesh, std::span<const Index> face)
    : mesh_(mesh),
      face_(face),
      around_(triangles_at_vertices(mesh.triangles, mesh.vertex_count())) {}

/// Whether a nearer one was found. Those without area have no weights that tell where p is.
bool NearbyPlaces::look_around(Vec3 p, Index face, std::span<const Index> vertices,
                               Best& best) const {
  const Index before = best.triangle;
  for (const Index v : vertices)
    for (const Index t : around_.row(v)) {
      if (face != none && face_[t] != face) continue;
      const auto [i, j, k] = mesh_.triangles[t];
      const Vec3 a = mesh_.points[i], b = mesh_.points[j], c = mesh_.points[k];
      if (!(squared_length(cross(b - a, c - a)) > 0)) continue;
      const Vec3 point = nearest_in_triangle(p, a, b, c);
      const double found = squared_length(point - p);
      if (best.triangle == none || found < best.squared_distance) best = {t, point, found};
    }
  return best.triangle != before;
}

SurfacePlace NearbyPlaces::place_of(const Best& best) const {
  const auto [i, j, k] = mesh_.triangles[best.triangle];
  const Vec3 a = mesh_.points[i], b = mesh_.points[j], c = mesh_.points[k], q = best.point;
  const Vec3 normal = cross(b - a, c - a);
  const double whole = squared_length(normal);
  const double wa = std::clamp(dot(cross(c - b, q - b), normal) / whole, 0.0, 1.0);
  const double wb = std::clamp(dot(cross(a - c, q - c), normal) / whole, 0.0, 1.0 - wa);
  return {best.triangle, {wa, wb, 1 - wa - wb}};
}

SurfacePlace NearbyPlaces::nearest(Vec3 p, Index face, std::span<const Index> vertices) const {
  Best best;
  if (!look_around(p, face, vertices, best)) {
    face = none;
    if (!look_around(p, face, vertices, best))  // nothing but flat ones
      return {around_.row(vertices[0])[0], {1, 0, 0}};
  }
  while (look_around(p, face, mesh_.triangles[best.triangle], best)) {
  }
  return place_of(best);
}

}  // namespace lpq

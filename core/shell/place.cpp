// See place.h.
#include "shell/place.h"

#include <algorithm>

namespace lpq {

SurfacePlace place_on(const Chart& chart, const Fields& fields, Vec2 p, Index& hint) {
  const Index t = fields.locator.find_nearest(p, hint);
  const auto [i, j, k] = chart.plane.triangles[t];
  const Vec2 a = chart.plane.points[i], b = chart.plane.points[j], c = chart.plane.points[k];
  const double area = cross(b - a, c - a);
  double wa = std::clamp(cross(c - b, p - b) / area, 0.0, 1.0);
  double wb = std::clamp(cross(a - c, p - c) / area, 0.0, 1.0 - wa);
  return {chart.triangles[t], {wa, wb, 1 - wa - wb}};
}

Vec3 point_at(const SurfaceMesh& mesh, const SurfacePlace& place) {
  const Tri& corners = mesh.triangles[place.triangle];
  Vec3 p{};
  for (int k = 0; k < 3; ++k) p += place.weight[k] * mesh.points[corners[k]];
  return p;
}

}  // namespace lpq

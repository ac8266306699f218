// See chart_fields.h.
#include "shell/chart_fields.h"

#include "surface/charts/carry.h"

namespace lpq {
namespace {

double plane_area(const TriMesh& plane, Index t) {
  const auto [a, b, c] = plane.triangles[t];
  return 0.5 * cross(plane.points[b] - plane.points[a], plane.points[c] - plane.points[a]);
}

/// Crosses of triangles, averaged at the vertices by area.
std::vector<Vec2> crosses_at_vertices(const TriMesh& plane, std::span<const Vec2> of_triangles) {
  std::vector<Vec2> z(plane.points.size());
  for (Index t = 0; t < plane.triangle_count(); ++t)
    for (const Index v : plane.triangles[t]) z[v] += plane_area(plane, t) * of_triangles[t];
  for (Vec2& value : z) {
    const double norm = length(value);
    value = norm > 0 ? (1 / norm) * value : Vec2{1, 0};
  }
  return z;
}

}  // namespace

Fields chart_fields(const SurfaceMesh& mesh, const SurfaceCrossField& cross,
                    std::span<const double> size, const Chart& chart) {
  Fields fields;
  fields.background = chart.plane;
  fields.z = crosses_at_vertices(chart.plane, crosses_in_plane(mesh, chart, cross.z));
  fields.h = sizes_in_plane(mesh, chart, size);
  fields.attach();
  return fields;
}

}  // namespace lpq

// See chart_fields.h.
#include "shell/chart_fields.h"

#include "surface/charts/carry.h"

namespace lpq {
namespace {

// Mean of |mu|: sigma_1 / sigma_2 of 1.2. Below that, as conformal maps of coarse triangles are, it
// made no difference: what it changes from triangle to triangle is as much noise as help.
constexpr double least_stretch = 0.1;

double plane_area(const TriMesh& plane, Index t) {
  const auto [a, b, c] = plane.triangles[t];
  return 0.5 * cross(plane.points[b] - plane.points[a], plane.points[c] - plane.points[a]);
}

/// Values of triangles, added up at the vertices times their areas.
std::vector<Vec2> sums_at_vertices(const TriMesh& plane, std::span<const Vec2> of_triangles) {
  std::vector<Vec2> sum(plane.points.size());
  for (Index t = 0; t < plane.triangle_count(); ++t)
    for (const Index v : plane.triangles[t]) sum[v] += plane_area(plane, t) * of_triangles[t];
  return sum;
}

std::vector<Vec2> crosses_at_vertices(const TriMesh& plane, std::span<const Vec2> of_triangles) {
  std::vector<Vec2> z = sums_at_vertices(plane, of_triangles);
  for (Vec2& value : z) {
    const double norm = length(value);
    value = norm > 0 ? (1 / norm) * value : Vec2{1, 0};
  }
  return z;
}

/// Empty where the map is as good as conformal.
std::vector<Vec2> stretches_at_vertices(const TriMesh& plane, std::span<const Vec2> of_triangles) {
  double sum = 0, whole = 0;
  for (Index t = 0; t < plane.triangle_count(); ++t) {
    sum += plane_area(plane, t) * length(of_triangles[t]);
    whole += plane_area(plane, t);
  }
  if (sum < least_stretch * whole) return {};
  const std::vector<Vec2> ones(of_triangles.size(), {1, 0});
  const std::vector<Vec2> area = sums_at_vertices(plane, ones);
  std::vector<Vec2> mu = sums_at_vertices(plane, of_triangles);
  for (std::size_t v = 0; v < mu.size(); ++v)
    if (area[v].x > 0) mu[v] = (1 / area[v].x) * mu[v];
  return mu;
}

}  // namespace

Fields chart_fields(const SurfaceMesh& mesh, const SurfaceCrossField& cross,
                    std::span<const double> size, const Chart& chart) {
  Fields fields;
  fields.background = chart.plane;
  fields.z = crosses_at_vertices(chart.plane, crosses_in_plane(mesh, chart, cross.z));
  fields.stretch = stretches_at_vertices(chart.plane, stretches_in_plane(mesh, chart));
  fields.h = sizes_in_plane(mesh, chart, size);
  fields.attach();
  return fields;
}

}  // namespace lpq

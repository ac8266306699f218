#include "surface/charts/carry.h"

#include "field/field.h"
#include "surface/frames.h"

namespace lpq {

std::vector<Vec2> crosses_in_plane(const SurfaceMesh& mesh, const Chart& chart,
                                   std::span<const Vec2> z) {
  std::vector<Vec2> result;
  result.reserve(chart.triangles.size());
  for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
    const TriangleLayout layout = layout_of(mesh, chart.triangles[t]);
    const auto [a, b, c] = chart.plane.triangles[t];
    const Vec2 ab = chart.plane.points[b] - chart.plane.points[a];
    const Vec2 ac = chart.plane.points[c] - chart.plane.points[a];
    // J = [ab ac] [side_0 -side_2]^-1; its part that turns with the triangle is (xx + yy, xy - yx),
    // here times the positive determinant of the layout.
    const Vec2 q = -layout.side[2];
    const Vec2 jx = q.y * ab, jy = layout.side[0].x * ac - q.x * ab;
    const Vec2 turning{jx.x + jy.y, jx.y - jy.x};
    result.push_back(complex_product(cross_of(turning), z[chart.triangles[t]]));
  }
  return result;
}

std::vector<double> sizes_in_plane(const SurfaceMesh& mesh, const Chart& chart,
                                   std::span<const double> h) {
  std::vector<double> sum(chart.vertex.size(), 0.0), area(chart.vertex.size(), 0.0);
  for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
    const double weight = layout_of(mesh, chart.triangles[t]).area;
    for (const Index v : chart.plane.triangles[t]) {
      sum[v] += weight * chart.scale[t];
      area[v] += weight;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] = h[chart.vertex[v]] * (area[v] > 0 ? sum[v] / area[v] : 1);
  return sum;
}

}  // namespace lpq

#include "surface/charts/carry.h"

#include "field/field.h"
#include "surface/frames.h"

namespace lpq {

namespace {

// The map J of a triangle is w v + g conj(v): its parts that turn with the triangle and against it.
struct MapParts {
  Vec2 with, against;  // times a common factor > 0
};

MapParts parts_of(const SurfaceMesh& mesh, const Chart& chart, std::size_t t) {
  const TriangleLayout layout = layout_of(mesh, chart.triangles[t]);
  const auto [a, b, c] = chart.plane.triangles[t];
  const Vec2 ab = chart.plane.points[b] - chart.plane.points[a];
  const Vec2 ac = chart.plane.points[c] - chart.plane.points[a];
  // J = [ab ac] [side_0 -side_2]^-1, here times the positive determinant of the layout.
  const Vec2 q = -layout.side[2];
  const Vec2 jx = q.y * ab, jy = layout.side[0].x * ac - q.x * ab;
  return {{jx.x + jy.y, jx.y - jy.x}, {jx.x - jy.y, jx.y + jy.x}};
}

}  // namespace

std::vector<Vec2> crosses_in_plane(const SurfaceMesh& mesh, const Chart& chart,
                                   std::span<const Vec2> z) {
  std::vector<Vec2> result;
  result.reserve(chart.triangles.size());
  for (std::size_t t = 0; t < chart.triangles.size(); ++t)
    result.push_back(
        complex_product(cross_of(parts_of(mesh, chart, t).with), z[chart.triangles[t]]));
  return result;
}

std::vector<Vec2> stretches_in_plane(const SurfaceMesh& mesh, const Chart& chart) {
  std::vector<Vec2> result;
  result.reserve(chart.triangles.size());
  for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
    // J^-1 u is conj(w) u - g conj(u), but for a factor.
    const auto [with, against] = parts_of(mesh, chart, t);
    const double norm2 = squared_length(with);
    const Vec2 mu = norm2 > 0 ? (-1 / norm2) * complex_product(against, with) : Vec2{0, 0};
    const double size = length(mu);
    result.push_back(size > most_stretch ? (most_stretch / size) * mu : mu);
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

#include "surface/curvature.h"

#include <algorithm>
#include <cmath>

#include "surface/fans.h"
#include "surface/frames.h"

namespace lpq {
namespace {

// A triangle flatter than this share of its longest squared side says nothing about bending.
constexpr double least_area_ratio = 1e-6;

// Normals of the fans, exact on a sphere whatever the triangles [Max 1999].
std::vector<Vec3> fan_normals(const SurfaceMesh& mesh, const SurfaceFans& fans) {
  std::vector<Vec3> normals(fans.count());
  for (Index f = 0; f < fans.count(); ++f) {
    for (const Index e : fans.corners.row(f)) {
      const Vec3 p = mesh.points[mesh.origin(e)];
      const Vec3 a = mesh.points[mesh.target(e)] - p, b = mesh.points[mesh.apex(e)] - p;
      const double weight = squared_length(a) * squared_length(b);
      if (weight > 0) normals[f] += (1 / weight) * cross(a, b);
    }
    const double norm = length(normals[f]);
    if (norm > 0) normals[f] = (1 / norm) * normals[f];
  }
  return normals;
}

// The normal is interpolated linearly; its derivative is symmetric but for noise.
SecondForm form_of(const TriangleLayout& layout, const TriangleAxes& axes, const Vec3 (&n)[3]) {
  SecondForm form;
  for (int k = 0; k < 3; ++k) {
    const Vec2 gradient = (0.5 / layout.area) * perpendicular(layout.side[(k + 1) % 3]);
    const double nx = dot(n[k], axes.x), ny = dot(n[k], axes.y);
    form.xx += nx * gradient.x;
    form.xy += 0.5 * (nx * gradient.y + ny * gradient.x);
    form.yy += ny * gradient.y;
  }
  return form;
}

}  // namespace

std::vector<SecondForm> second_forms(const SurfaceMesh& mesh, std::span<const char> feature) {
  const SurfaceFans fans = fans_of(mesh.twins, feature);
  const std::vector<Vec3> normals = fan_normals(mesh, fans);
  std::vector<SecondForm> forms(mesh.triangles.size());
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleLayout layout = layout_of(mesh, t);
    double longest2 = 0;
    for (const Vec2 side : layout.side) longest2 = std::max(longest2, squared_length(side));
    if (!(layout.area > least_area_ratio * longest2)) continue;
    Vec3 n[3];
    for (int k = 0; k < 3; ++k) n[k] = normals[fans.of_corner[3 * t + k]];
    forms[t] = form_of(layout, axes_of(mesh, t), n);
  }
  return forms;
}

double largest_curvature(const SecondForm& form) {
  const double mean = 0.5 * (form.xx + form.yy);
  const double half_difference = 0.5 * (form.xx - form.yy);
  return std::abs(mean) + std::sqrt(half_difference * half_difference + form.xy * form.xy);
}

}  // namespace lpq

#include "surface/normals.h"

#include <algorithm>

namespace lpq {
namespace {

// Coordinates often are single precision: 6e-8 of the size of the model, and a triangle as low as
// that can point anywhere. A low triangle that is small altogether is trusted.
constexpr double noise_height = 1e-7;  // of the diagonal
constexpr double noise_aspect = 1e-4;  // height over longest edge
constexpr double worst_aspect = 1e-9;  // not trusted at any size

struct Shape {
  Vec3 area;       // twice the area along the normal
  double longest;  // edge, squared
  Index across;    // half-edge of it
};

Shape shape_of(const SurfaceMesh& mesh, Index t) {
  const auto& [a, b, c] = mesh.triangles[t];
  Shape shape{cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]), -1, none};
  for (Index e = 3 * t; e < 3 * t + 3; ++e) {
    const double squared =
        squared_length(mesh.points[mesh.target(e)] - mesh.points[mesh.origin(e)]);
    if (squared <= shape.longest) continue;
    shape.longest = squared;
    shape.across = e;
  }
  return shape;
}

bool is_noise(const Shape& shape, double diagonal) {
  const double area = squared_length(shape.area), longest = shape.longest;
  const auto lower_than = [&](double height) { return area <= height * height * longest; };
  const double edge = std::sqrt(longest);
  return lower_than(worst_aspect * edge) ||
         (lower_than(noise_height * diagonal) && lower_than(noise_aspect * edge));
}

}  // namespace

double bounding_diagonal(const std::vector<Vec3>& points) {
  if (points.empty()) return 0;
  Vec3 low = points[0], high = points[0];
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return length(high - low);
}

std::vector<Vec3> triangle_normals(const SurfaceMesh& mesh) {
  const double diagonal = bounding_diagonal(mesh.points);
  std::vector<Vec3> normals(mesh.triangles.size());
  std::vector<Index> noisy;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const Shape shape = shape_of(mesh, t);
    if (is_noise(shape, diagonal)) {
      noisy.push_back(t);
    } else {
      normals[t] = (1 / length(shape.area)) * shape.area;
    }
  }
  // Normals spread through heaps of noisy triangles, a layer at a time.
  for (std::size_t before = 0; before != noisy.size();) {
    before = noisy.size();
    std::erase_if(noisy, [&](Index t) {
      const Index twin = mesh.twins[shape_of(mesh, t).across];
      if (twin == none) return false;
      normals[t] = normals[triangle_of(twin)];
      return !(normals[t] == Vec3{});
    });
  }
  return normals;
}

}  // namespace lpq

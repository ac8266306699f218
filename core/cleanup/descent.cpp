#include "cleanup/descent.h"

#include <algorithm>
#include <cmath>

namespace lpq {
namespace {

constexpr double largest_move = 0.2;  // per iteration, in units of the vertex's size

}  // namespace

std::vector<double> vertex_sizes(const QuadMesh& mesh) {
  std::vector<double> sum(mesh.points.size(), 0.0);
  std::vector<Index> count(mesh.points.size(), 0);
  for (const Face& face : mesh.faces) {
    const int n = corner_count(face);
    for (int k = 0; k < n; ++k) {
      const Index a = face[k], b = face[(k + 1) % n];
      const double squared = squared_length(mesh.points[b] - mesh.points[a]);
      if (!(squared > 0)) continue;
      for (const Index v : {a, b}) {
        sum[v] += 1 / squared;
        ++count[v];
      }
    }
  }
  std::vector<double> sizes;
  for (std::size_t v = mesh.fixed; v < mesh.points.size(); ++v)
    sizes.push_back(count[v] == 0 ? 0 : std::sqrt(count[v] / sum[v]));
  return sizes;
}

std::vector<double> own_inverse_squares(std::span<const Face> faces, std::span<const Vec2> points) {
  std::vector<double> result;
  result.reserve(faces.size());
  for (const Face& face : faces) {
    const int n = corner_count(face);
    double sum = 0;
    for (int k = 0; k < n; ++k) sum += squared_length(points[face[(k + 1) % n]] - points[face[k]]);
    result.push_back(sum > 0 ? n / sum : 0);
  }
  return result;
}

int descend(QuadMesh& mesh, std::span<const double> sizes, int iterations, VertexEnergy energy) {
  const std::size_t fixed = mesh.fixed, free = sizes.size();
  if (free == 0 || iterations <= 0) return 0;
  const std::vector<Vec2> start(mesh.points.begin() + mesh.fixed, mesh.points.end());
  std::vector<Vec2> gradient(mesh.points.size());
  const auto place = [&](std::span<const double> y) {
    for (std::size_t i = 0; i < free; ++i)
      mesh.points[fixed + i] = start[i] + sizes[i] * Vec2{y[2 * i], y[2 * i + 1]};
  };
  const auto objective = [&](std::span<const double> y, std::span<double> by_y) {
    place(y);
    std::fill(gradient.begin(), gradient.end(), Vec2{});
    const Evaluation result = energy(mesh.points, gradient);
    for (std::size_t i = 0; i < free; ++i) {
      by_y[2 * i] = sizes[i] * gradient[fixed + i].x;
      by_y[2 * i + 1] = sizes[i] * gradient[fixed + i].y;
    }
    return result;
  };
  Lbfgs descent(std::vector<double>(2 * free, 0.0), {.value_tolerance = 1e-6},
                std::vector<double>(2 * free, largest_move));
  descent.step(iterations, objective);
  place(descent.x());
  return descent.iterations();
}

}  // namespace lpq

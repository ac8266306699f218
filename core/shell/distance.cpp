// See distance.h.
#include "shell/distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/sort_numbers.h"
#include "shell/face_fans.h"
#include "shell/nearest_triangle.h"
#include "shell/triangle_places.h"

namespace lpq {
namespace {

constexpr double sample_step = 0.25;  // of the mean side
constexpr double most_samples = 32;   // of the surface for each face of the mesh

/// Points with the areas they stand for.
struct Samples {
  std::vector<Vec3> points;
  std::vector<double> weight;
};

double area_of(Vec3 a, Vec3 b, Vec3 c) { return 0.5 * length(cross(b - a, c - a)); }

/// All points, and the middles of the mesh's edges, by the trapezoidal rule at half steps.
Samples fan_samples(const FaceFans& fans) {
  Samples result{fans.points, std::vector<double>(fans.points.size(), 0)};
  struct Side {
    std::array<Index, 2> ends;
    double weight;
  };
  std::vector<Side> sides;
  for (const auto& [a, b, middle] : fans.triangles) {
    const double quarter = 0.25 * area_of(fans.points[a], fans.points[b], fans.points[middle]);
    result.weight[middle] += quarter;
    result.weight[a] += 0.5 * quarter;
    result.weight[b] += 0.5 * quarter;
    sides.push_back({{std::min(a, b), std::max(a, b)}, 2 * quarter});
  }
  sort_values(sides, [](const Side& s, const Side& t) {
    return s.ends != t.ends ? s.ends < t.ends : s.weight < t.weight;
  });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && sides[i].ends == sides[i - 1].ends) {
      result.weight.back() += sides[i].weight;
      continue;
    }
    result.points.push_back(midpoint(fans.points[sides[i].ends[0]], fans.points[sides[i].ends[1]]));
    result.weight.push_back(sides[i].weight);
  }
  return result;
}

double longest_side(const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  return std::max({distance(a, b), distance(b, c), distance(c, a)});
}

/// Vertices, and places about `step` apart inside triangles that are longer.
Samples surface_samples(std::span<const Vec3> points, std::span<const Tri> triangles, double step) {
  std::vector<double> weight(points.size(), 0);
  std::vector<char> used(points.size(), 0);
  Samples result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Tri& t = triangles[i];
    const std::array<Vec3, 3> corners{points[t[0]], points[t[1]], points[t[2]]};
    const bool large = longest_side(corners) > step;
    for (const Index v : t) {
      used[v] = 1;
      if (!large) weight[v] += area_of(corners[0], corners[1], corners[2]) / 3;
    }
    if (!large) continue;
    const auto add = [&](const std::array<double, 3>& at, double area) {
      result.points.push_back(at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2]);
      result.weight.push_back(area);
    };
    visit_places(corners, step, static_cast<Index>(i), add);
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!used[v]) continue;
    result.points.push_back(points[v]);
    result.weight.push_back(weight[v]);
  }
  return result;
}

/// Not too many where a few faces are far smaller than the others.
double least_step(std::span<const Vec3> points, std::span<const Tri> triangles,
                  const ShellMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) area += area_of(points[a], points[b], points[c]);
  return std::sqrt(area / (most_samples * static_cast<double>(mesh.faces.size())));
}

double mean_side(const ShellMesh& mesh) {
  double sum = 0;
  int count = 0;
  for (const Face& face : mesh.faces) {
    const int n = corner_count(face);
    for (int k = 0; k < n; ++k)
      sum += distance(mesh.points[face[k]], mesh.points[face[(k + 1) % n]]);
    count += n;
  }
  return sum / count;
}

Distance measure(const Samples& samples, const NearestTriangle& target) {
  Distance result;
  double sum = 0, weights = 0;
  Index hint = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const double distance = target.distance(samples.points[i], hint);
    if (distance > result.max) {
      result.max = distance;
      result.at = samples.points[i];
    }
    sum += samples.weight[i] * distance;
    weights += samples.weight[i];
  }
  if (weights > 0) result.mean = sum / weights;
  return result;
}

}  // namespace

SurfaceDistance surface_distance(std::span<const Vec3> points, std::span<const Tri> triangles,
                                 const ShellMesh& mesh) {
  const FaceFans fans = face_fans(mesh);
  const NearestTriangle surface(points, triangles), faces(fans.points, fans.triangles);
  const double step = std::max(sample_step * mean_side(mesh), least_step(points, triangles, mesh));
  return {measure(fan_samples(fans), surface),
          measure(surface_samples(points, triangles, step), faces)};
}

}  // namespace lpq

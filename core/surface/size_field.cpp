#include "surface/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "geometry/box.h"
#include "mesh/limit_growth.h"
#include "mesh/neighbours.h"
#include "numerics/elementary.h"
#include "surface/components.h"
#include "surface/curvature.h"
#include "surface/frames.h"

namespace lpq {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Of the diagonal of a part: that of one square. With larger quads it folds up.
constexpr double largest_share = 0.7;

Error bad_size(std::string message) { return {ErrorCode::bad_size, std::move(message), {}}; }

// The mean over the triangles round each vertex, by area: single noisy triangles count little.
std::vector<double> bending_of_surface(const SurfaceMesh& mesh, std::span<const char> feature) {
  const std::vector<SecondForm> forms = second_forms(mesh, feature);
  std::vector<double> sum(mesh.points.size(), 0.0), area(mesh.points.size(), 0.0);
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const double a = layout_of(mesh, t).area, curvature = largest_curvature(forms[t]);
    for (const Index v : mesh.triangles[t]) {
      sum[v] += a * curvature;
      area[v] += a;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = area[v] > 0 ? sum[v] / area[v] : 0;
  return sum;
}

// Curvature of the polyline at its inner vertices, those where exactly two feature edges meet, from
// the circle through three points: 2 sin(turn) / |a - c|. Sharper turns than a right angle are
// corners.
void add_bending_of_features(const SurfaceMesh& mesh, std::span<const char> feature,
                             std::vector<double>& bending) {
  std::vector<std::array<Index, 2>> ends(mesh.points.size(), {none, none});
  std::vector<int> count(mesh.points.size(), 0);
  for (Index e = 0; e < static_cast<Index>(mesh.twins.size()); ++e) {
    const Index twin = mesh.twins[e];
    const bool marked = twin == none || (!feature.empty() && feature[e]);
    if (!marked || (twin != none && twin < e)) continue;
    const Index a = mesh.origin(e), b = mesh.target(e);
    if (count[a]++ < 2) ends[a][count[a] - 1] = b;
    if (count[b]++ < 2) ends[b][count[b] - 1] = a;
  }
  for (std::size_t v = 0; v < count.size(); ++v) {
    if (count[v] != 2) continue;
    const Vec3 in = mesh.points[v] - mesh.points[ends[v][0]];
    const Vec3 out = mesh.points[ends[v][1]] - mesh.points[v];
    const double product = length(in) * length(out), chord = length(in + out);
    if (!(dot(in, out) > 0) || !(product * chord > 0)) continue;
    bending[v] = std::max(bending[v], 2 * length(cross(in, out)) / (product * chord));
  }
}

double size_for(double curvature, const SurfaceSizeOptions& options) {
  if (!(curvature > 0)) return infinite;
  const double r = 1 / curvature;
  const double chord = 2 * r * sin_cos(0.5 * std::min(options.largest_turn, pi)).sin;
  return std::max(chord, options.least);
}

std::string fault_of(const SurfaceMesh& mesh, const SurfaceSizeOptions& options) {
  const auto bad = [](double value) { return !std::isfinite(value) || value < 0; };
  if (bad(options.size) || bad(options.least)) return "sizes must be positive numbers";
  if (bad(options.largest_turn)) return "the largest turn must be a positive angle in radians";
  if (bad(options.growth) || options.growth == 0) return "the growth must be positive";
  if (!options.at_vertices.empty() && options.at_vertices.size() != mesh.points.size())
    return "there must be one size for every vertex of the surface";
  for (const double value : options.at_vertices)
    if (bad(value)) return "sizes at vertices must be positive numbers";
  return "";
}

}  // namespace

void limit_surface_growth(const SurfaceMesh& mesh, double growth, std::span<double> h) {
  limit_growth(vertex_neighbours(mesh.triangles, mesh.vertex_count()), h,
               [&](Index v, Index w) { return growth * distance(mesh.points[v], mesh.points[w]); });
}

Result<std::vector<double>> surface_sizes(const SurfaceMesh& mesh, std::span<const char> feature,
                                          const SurfaceSizeOptions& options) {
  const std::string fault = fault_of(mesh, options);
  if (!fault.empty()) return bad_size(fault);
  std::vector<double> h(mesh.points.size(), options.size > 0 ? options.size : infinite);
  for (std::size_t v = 0; v < options.at_vertices.size(); ++v)
    if (options.at_vertices[v] > 0) h[v] = options.at_vertices[v];
  if (options.largest_turn > 0) {
    std::vector<double> bending = bending_of_surface(mesh, feature);
    add_bending_of_features(mesh, feature, bending);
    for (std::size_t v = 0; v < h.size(); ++v) h[v] = std::min(h[v], size_for(bending[v], options));
  }
  limit_surface_growth(mesh, options.growth, h);
  for (const Tri& tri : mesh.triangles)
    for (const Index v : tri)
      if (!std::isfinite(h[v]))
        return bad_size("a part of the surface is flat and has no size: give a constant one");
  for (double& value : h)
    if (!std::isfinite(value)) value = 1;  // points of no triangle
  limit_to_parts(mesh, largest_share, h);
  return h;
}

void limit_to_parts(const SurfaceMesh& mesh, double share, std::span<double> h) {
  const Components parts = components_of(mesh.twins);
  std::vector<Box3> boxes(parts.count);
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    for (const Index v : mesh.triangles[t]) extend(boxes[parts.of_triangle[t]], mesh.points[v]);
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    for (const Index v : mesh.triangles[t])
      h[v] = std::min(h[v], share * diagonal(boxes[parts.of_triangle[t]]));
}

double surface_capacity(const SurfaceMesh& mesh, std::span<const double> h) {
  double sum = 0;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const double area = layout_of(mesh, t).area;
    for (Index k = 0; k < 3; ++k) {  // midpoints of the edges: exact for quadratics
      const double middle = 0.5 * (h[mesh.triangles[t][k]] + h[mesh.triangles[t][(k + 1) % 3]]);
      sum += area / 3 / (middle * middle);
    }
  }
  return sum;
}

}  // namespace lpq

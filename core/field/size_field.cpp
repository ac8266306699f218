#include "field/size_field.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

#include "delaunay/locate.h"
#include "geometry/segment.h"
#include "mesh/limit_growth.h"
#include "mesh/neighbours.h"
#include "numerics/elementary.h"
#include "numerics/sparse.h"

namespace lpq {
namespace {

constexpr double least_area_ratio = 1e-13;  // needle triangles: see cross_field.cpp

// Linear elements: K_km = s_k . s_m / (4 area) with s_k the edge opposite corner k.
void assemble(const TriMesh& mesh, std::span<const Index> unknown, std::span<const double> value,
              std::vector<Triplet>& matrix, std::vector<double>& rhs) {
  for (const Tri& tri : mesh.triangles) {
    Vec2 side[3];
    double longest2 = 0;
    for (int k = 0; k < 3; ++k) {
      side[k] = mesh.points[tri[(k + 2) % 3]] - mesh.points[tri[(k + 1) % 3]];
      longest2 = std::max(longest2, squared_length(side[k]));
    }
    const double area = std::max(0.5 * cross(side[0], side[1]), least_area_ratio * longest2);
    for (int k = 0; k < 3; ++k) {
      const Index row = unknown[tri[k]];
      if (row == none) continue;
      for (int m = 0; m < 3; ++m) {
        const double entry = dot(side[k], side[m]) / (4 * area);
        const Index column = unknown[tri[m]];
        if (column == none)
          rhs[row] -= entry * value[tri[m]];
        else if (column <= row)
          matrix.push_back({row, column, entry});
      }
    }
  }
}

/// A vertex that a cone has lowered to h.
struct Lowered {
  double h;
  Index vertex, cone;
  bool operator>(const Lowered& other) const {
    return std::tie(h, vertex, cone) > std::tie(other.h, other.vertex, other.cone);
  }
};

/// From the vertices in the queue on to all that their cones lower.
void spread(const TriMesh& mesh, std::span<const SizeCone> cones, std::vector<Lowered> from,
            std::span<double> h) {
  const Csr<Index> neighbours = vertex_neighbours(mesh.triangles, mesh.vertex_count());
  std::priority_queue<Lowered, std::vector<Lowered>, std::greater<>> queue(std::greater<>{},
                                                                           std::move(from));
  while (!queue.empty()) {
    const Lowered top = queue.top();
    queue.pop();
    if (top.h > h[top.vertex]) continue;
    const SizeCone& cone = cones[top.cone];
    for (const Index w : neighbours.row(top.vertex)) {
      const double lower = cone.at(distance(cone.tip, mesh.points[w]));
      if (!(lower < h[w])) continue;
      h[w] = lower;
      queue.push({lower, w, top.cone});
    }
  }
}

}  // namespace

std::vector<double> harmonic_size(const TriMesh& mesh, const BoundaryMesh& boundary) {
  double unit = std::numeric_limits<double>::infinity();
  for (const double s : boundary.spacing)
    if (s > 0) unit = std::min(unit, s);
  std::vector<double> log_h(mesh.points.size(), 0.0);
  std::vector<Index> unknown(mesh.points.size(), none);
  Index n = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double spacing = v < boundary.spacing.size() ? boundary.spacing[v] : 0;
    if (spacing > 0)
      log_h[v] = logarithm(spacing / unit);
    else
      unknown[v] = n++;
  }
  std::vector<Triplet> matrix;
  std::vector<double> rhs(n, 0.0), solution;
  assemble(mesh, unknown, log_h, matrix, rhs);
  solve_spd(n, matrix, rhs, 1, solution);
  std::vector<double> h(mesh.points.size());
  for (std::size_t v = 0; v < h.size(); ++v)
    h[v] = unknown[v] == none ? boundary.spacing[v] : unit * exponential(solution[unknown[v]]);
  return h;
}

void limit_by_walls(const BoundaryMesh& boundary, std::span<double> h) {
  for (std::size_t v = 0; v < boundary.spacing.size(); ++v)
    if (boundary.spacing[v] > 0) h[v] = std::min(h[v], boundary.spacing[v]);
}

double distance_to_triangle(const TriMesh& mesh, Index t, Vec2 p) {
  const Tri& tri = mesh.triangles[t];
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const Vec2 a = mesh.points[tri[k]], b = mesh.points[tri[(k + 1) % 3]];
    inside = inside && cross(b - a, p - a) >= 0;
    nearest = std::min(nearest, distance(p, closest_point(p, a, b)));
  }
  return inside ? 0 : nearest;
}

void limit_by_cones(const TriMesh& mesh, std::span<const SizeCone> cones, double growth,
                    std::span<double> h) {
  if (cones.empty()) return;
  const Locator locator(mesh);
  Index hint = none;
  std::vector<Lowered> lowered;
  for (Index c = 0; c < static_cast<Index>(cones.size()); ++c) {
    const SizeCone& cone = cones[c];
    const Index t = locator.find_nearest(cone.tip, hint);
    if (t == none) continue;
    const double there = cone.at(distance_to_triangle(mesh, t, cone.tip));
    for (const Index v : mesh.triangles[t]) {
      h[v] = std::min(h[v], there);
      lowered.push_back({there, v, c});
    }
  }
  if (wider_than_growth(cones, growth)) spread(mesh, cones, std::move(lowered), h);
}

void limit_growth(const TriMesh& mesh, double growth, std::span<double> h) {
  limit_growth(vertex_neighbours(mesh.triangles, mesh.vertex_count()), h,
               [&](Index v, Index w) { return growth * distance(mesh.points[v], mesh.points[w]); });
}

}  // namespace lpq

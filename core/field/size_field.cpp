#include "field/size_field.h"

#include <algorithm>
#include <limits>

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

void limit_growth(const TriMesh& mesh, double growth, std::span<double> h) {
  limit_growth(vertex_neighbours(mesh.triangles, mesh.vertex_count()), h,
               [&](Index v, Index w) { return growth * distance(mesh.points[v], mesh.points[w]); });
}

}  // namespace lpq

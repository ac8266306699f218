#include "surface/cross_field.h"

#include <algorithm>
#include <complex>

#include "field/field.h"
#include "surface/components.h"
#include "surface/cross_system.h"
#include "surface/frames.h"

namespace lpq {
namespace {

using Complex = std::complex<double>;

// Below this length the mean of unit values says nothing: see field/cross_field.cpp.
constexpr double consistent_mean = 0.3;
// Two triangles across an edge count as no flatter than this: it bounds the stiffness of needles.
constexpr double least_area_ratio = 1e-4;

Complex complex_of(Vec2 z) { return {z.x, z.y}; }

class CrossSolver {
 public:
  CrossSolver(const SurfaceMesh& mesh, std::span<const char> feature);
  std::vector<Vec2> solve() const;

 private:
  void fix_at_features(std::span<const char> feature);
  void assemble();
  void find_free_components();
  Index rows() const { return static_cast<Index>(triangle_.size()); }

  const SurfaceMesh& mesh_;
  std::vector<TriangleLayout> layouts_;
  std::vector<Vec2> transport_;
  std::vector<Complex> fixed_;   // #T  0 where unknown
  std::vector<Index> row_of_;    // #T  none where fixed
  std::vector<Index> triangle_;  // #rows
  CrossSystem system_;
};

CrossSolver::CrossSolver(const SurfaceMesh& mesh, std::span<const char> feature)
    : mesh_(mesh), transport_(cross_transport(mesh)) {
  layouts_.reserve(mesh.triangles.size());
  for (Index t = 0; t < mesh.triangle_count(); ++t) layouts_.push_back(layout_of(mesh, t));
  fix_at_features(feature);
  assemble();
  find_free_components();
}

void CrossSolver::fix_at_features(std::span<const char> feature) {
  fixed_.assign(mesh_.triangles.size(), {});
  row_of_.assign(mesh_.triangles.size(), none);
  double total_area = 0;
  for (const TriangleLayout& layout : layouts_) total_area += layout.area;
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    Complex sum;
    Vec2 longest;
    int count = 0;
    for (Index k = 0; k < 3; ++k) {
      const Index e = 3 * t + k;
      const Vec2 side = layouts_[t].side[k];
      const bool prescribed = mesh_.twins[e] == none || (!feature.empty() && feature[e]);
      if (!prescribed || squared_length(side) == 0) continue;
      sum += complex_of(cross_of(side));
      if (squared_length(side) > squared_length(longest)) longest = side;
      ++count;
    }
    if (count > 0) {
      const bool agreed = squared_norm(sum) > consistent_mean * consistent_mean * count * count;
      fixed_[t] = agreed ? unit_cross(sum) : complex_of(cross_of(longest));
    } else {
      row_of_[t] = rows();
      triangle_.push_back(t);
      system_.mass.push_back(total_area > 0 ? layouts_[t].area / total_area : 0);
    }
  }
}

// Finite volumes between centroids: edge length over the distance that the two heights span.
void CrossSolver::assemble() {
  system_.rhs.assign(rows(), {});
  for (Index row = 0; row < rows(); ++row)
    for (Index k = 0; k < 3; ++k) {
      const Index t = triangle_[row], twin = mesh_.twins[3 * t + k];
      if (twin == none) continue;  // an edge without length
      const Index other = triangle_of(twin);
      const double length2 = squared_length(layouts_[t].side[k]);
      const double areas = layouts_[t].area + layouts_[other].area;
      if (length2 == 0) continue;
      const double weight = 1.5 * length2 / std::max(areas, least_area_ratio * length2);
      const Complex coupling = weight * complex_of(transport_[twin]);
      system_.stiffness.push_back({row, row, weight});
      if (row_of_[other] == none)
        system_.rhs[row] += coupling * fixed_[other];
      else if (row_of_[other] < row)
        system_.stiffness.push_back({row, row_of_[other], -coupling});
    }
}

void CrossSolver::find_free_components() {
  const Components components = components_of(mesh_.twins);
  std::vector<char> free(components.count, 1);
  for (Index t = 0; t < mesh_.triangle_count(); ++t)
    if (row_of_[t] == none) free[components.of_triangle[t]] = 0;
  std::vector<Index> number(components.count, none);
  for (Index c = 0; c < components.count; ++c)
    if (free[c]) number[c] = system_.free_components++;
  for (const Index t : triangle_)
    system_.free_component.push_back(number[components.of_triangle[t]]);
}

std::vector<Vec2> CrossSolver::solve() const {
  const std::vector<Complex> x = solve_large_cross_system(system_);
  std::vector<Vec2> z(mesh_.triangles.size());
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    const Complex value = row_of_[t] == none ? fixed_[t] : x[row_of_[t]];
    z[t] = squared_norm(value) > 0 ? Vec2{value.real(), value.imag()} : Vec2{1, 0};
  }
  return z;
}

}  // namespace

std::vector<Vec2> cross_transport(const SurfaceMesh& mesh) {
  std::vector<Vec2> cross_of_side(mesh.twins.size(), {1, 0});
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleLayout layout = layout_of(mesh, t);
    for (Index k = 0; k < 3; ++k) cross_of_side[3 * t + k] = cross_of(layout.side[k]);
  }
  std::vector<Vec2> transport(mesh.twins.size(), {1, 0});
  for (Index e = 0; e < static_cast<Index>(mesh.twins.size()); ++e)
    if (mesh.twins[e] != none)
      transport[e] = complex_product(cross_of_side[mesh.twins[e]], conjugate(cross_of_side[e]));
  return transport;
}

SurfaceCrossField solve_surface_cross(const SurfaceMesh& mesh, std::span<const char> feature) {
  SurfaceCrossField field;
  field.z = CrossSolver(mesh, feature).solve();
  field.singularities = find_surface_singularities(mesh, field.z);
  return field;
}

}  // namespace lpq

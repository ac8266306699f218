#include "surface/normals.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "surface/components.h"

namespace lpq {
namespace {

// Coordinates often are single precision: 6e-8 of the size of the model, and a triangle as low as
// that can point anywhere. A low triangle that is small altogether is trusted.
constexpr double noise_height = 1e-7;  // of the diagonal
constexpr double noise_aspect = 1e-4;  // height over longest edge
constexpr double worst_aspect = 1e-9;  // not trusted at any size
// What is as low as this beside the mesh is no face of its own, whichever way it points; but many
// such triangles together may well be one, as the facets of a finely divided cylinder are.
constexpr double needle_height = 2e-3;  // of the mesh size
constexpr double needle_aspect = 1e-2;

class NormalFinder {
 public:
  NormalFinder(const SurfaceMesh& mesh, std::span<const double> size)
      : mesh_(mesh),
        size_(size),
        diagonal_(bounding_diagonal(mesh.points)),
        normals_(mesh.triangles.size()) {}

  std::vector<Vec3> run() {
    const std::vector<char> thin = thin_heaps();
    std::vector<Index> noisy;
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      const Vec3 area = doubled_area(t);
      if (thin[t] || is_noise(t)) {
        noisy.push_back(t);
      } else {
        normals_[t] = (1 / length(area)) * area;
      }
    }
    // Normals spread through heaps of noisy triangles, a layer at a time.
    while (spread(noisy, false) || spread(noisy, true)) {
    }
    return std::move(normals_);
  }

 private:
  Vec3 doubled_area(Index t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
  }

  double squared_edge(Index e) const {
    return squared_length(mesh_.points[mesh_.target(e)] - mesh_.points[mesh_.origin(e)]);
  }

  double squared_longest(Index t) const {
    return std::max({squared_edge(3 * t), squared_edge(3 * t + 1), squared_edge(3 * t + 2)});
  }

  /// Is the height over the longest edge below this?
  bool is_lower(Index t, double height) const {
    return squared_length(doubled_area(t)) <= height * height * squared_longest(t);
  }

  bool is_noise(Index t) const {
    const double edge = std::sqrt(squared_longest(t));
    return is_lower(t, worst_aspect * edge) ||
           (is_lower(t, noise_height * diagonal_) && is_lower(t, noise_aspect * edge));
  }

  bool is_needle(Index t) const {
    return is_lower(t, needle_aspect * std::sqrt(squared_longest(t))) &&
           is_lower(t, needle_height * size_[mesh_.triangles[t][0]]);
  }

  /// Needles that are no wider beside the mesh together with all needles that they hang together
  /// with: twice the area over the border's length is the mean width. #T
  std::vector<char> thin_heaps() const {
    std::vector<char> needle(mesh_.triangles.size(), 0);
    if (size_.empty()) return needle;
    for (Index t = 0; t < mesh_.triangle_count(); ++t) needle[t] = is_needle(t);
    std::vector<char> border(mesh_.twins.size(), 1);
    for (Index e = 0; e < static_cast<Index>(border.size()); ++e)
      border[e] = !needle[triangle_of(e)] || !has_same_group_behind(e) ||
                  !needle[triangle_of(mesh_.twins[e])];
    const Components heaps = components_of(mesh_.twins, border);
    std::vector<double> area(heaps.count, 0), around(heaps.count, 0);
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      area[heaps.of_triangle[t]] += 0.5 * length(doubled_area(t));
      for (Index e = 3 * t; e < 3 * t + 3; ++e)
        if (border[e]) around[heaps.of_triangle[t]] += std::sqrt(squared_edge(e));
    }
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      const Index heap = heaps.of_triangle[t];
      const double width = needle_height * size_[mesh_.triangles[t][0]];
      needle[t] = needle[t] && 2 * area[heap] <= width * around[heap];
    }
    return needle;
  }

  bool has_same_group_behind(Index e) const {
    return mesh_.twins[e] != none &&
           mesh_.group[triangle_of(mesh_.twins[e])] == mesh_.group[triangle_of(e)];
  }

  /// Of the same group: between two faces of a part the surface may turn.
  bool has_normal_behind(Index e) const {
    return has_same_group_behind(e) && !(normals_[triangle_of(mesh_.twins[e])] == Vec3{});
  }

  /// The longest half-edge, of all or of those with a normal behind them.
  Index longest_edge(Index t, bool with_normal) const {
    Index best = none;
    for (Index e = 3 * t; e < 3 * t + 3; ++e)
      if ((!with_normal || has_normal_behind(e)) &&
          (best == none || squared_edge(e) > squared_edge(best)))
        best = e;
    return best;
  }

  bool spread(std::vector<Index>& noisy, bool any_edge) {
    const std::size_t before = noisy.size();
    std::erase_if(noisy, [&](Index t) {
      const Index e = longest_edge(t, any_edge);
      if (e == none || !has_normal_behind(e)) return false;
      normals_[t] = normals_[triangle_of(mesh_.twins[e])];
      return true;
    });
    return noisy.size() != before;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  double diagonal_;
  std::vector<Vec3> normals_;
};

}  // namespace

std::vector<Vec3> triangle_normals(const SurfaceMesh& mesh, std::span<const double> size) {
  return NormalFinder(mesh, size).run();
}

}  // namespace lpq

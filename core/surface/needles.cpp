// See needles.h.
#include "surface/needles.h"

#include <algorithm>
#include <vector>

#include "surface/sharp_chains.h"

namespace lpq {
namespace {

// Of the mesh size; features as near as that are one line to the mesh.
constexpr double needle_height = 0.05;
constexpr double needle_aspect = 0.03;  // height over longest side

class NeedleFinder {
 public:
  NeedleFinder(const SurfaceMesh& mesh, std::span<const double> size,
               const SurfaceFeatures& features)
      : mesh_(mesh), size_(size), features_(features) {}

  /// The longest side of the triangle if it is a needle with a fold along two sides; else none.
  Index fold_of(Index t) const {
    Index longest = 3 * t;
    for (Index e = 3 * t + 1; e < 3 * t + 3; ++e)
      if (squared_side(e) > squared_side(longest)) longest = e;
    const Index next = next_in_triangle(longest), last = next_in_triangle(next);
    if (!is_sharp(longest) || is_sharp(next) == is_sharp(last)) return none;
    return is_needle(t, squared_side(longest)) ? longest : none;
  }

 private:
  bool is_sharp(Index e) const {
    return features_.kind[features_.edges.edge_of[e]] == FeatureKind::sharp;
  }
  double squared_side(Index e) const {
    return squared_length(mesh_.points[mesh_.target(e)] - mesh_.points[mesh_.origin(e)]);
  }
  bool is_needle(Index t, double longest) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    const double area =
        squared_length(cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]));
    const double height = needle_height * size_[a];
    return area <= height * height * longest &&
           area <= needle_aspect * needle_aspect * longest * longest;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  const SurfaceFeatures& features_;
};

}  // namespace

void unfold_needles(const SurfaceMesh& mesh, std::span<const double> size,
                    std::span<const double> angles, const FeatureOptions& options,
                    SurfaceFeatures& features) {
  const NeedleFinder needles(mesh, size, features);
  const SharpChains chains(mesh, angles, options.angle, features);
  std::vector<Index> folds;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const Index e = needles.fold_of(t);
    if (e != none && chains.is_rough(chains.through(features.edges.edge_of[e]), false))
      folds.push_back(e);
  }
  for (const Index e : folds) {
    const Index next = next_in_triangle(e), last = next_in_triangle(next);
    features.kind[features.edges.edge_of[e]] = FeatureKind::smooth;
    for (const Index side : {next, last}) {
      FeatureKind& kind = features.kind[features.edges.edge_of[side]];
      kind = std::max(kind, FeatureKind::sharp);
    }
  }
}

}  // namespace lpq

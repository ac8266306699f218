// See needles.h.
#include "surface/needles.h"

#include <algorithm>
#include <vector>

#include "numerics/elementary.h"
#include "surface/normals.h"
#include "surface/sharp_chains.h"
#include "surface/sharp_edges.h"

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

  struct Needle {
    Index longest = none;    // half-edge, none if the triangle is no needle with a fold
    bool has_three = false;  // all sides are sharp: it would be a face of its own
  };
  /// A needle is folded along its longest side and one other, or along all three.
  Needle needle_at(Index t) const {
    Index longest = 3 * t;
    for (Index e = 3 * t + 1; e < 3 * t + 3; ++e)
      if (squared_side(e) > squared_side(longest)) longest = e;
    const Index next = next_in_triangle(longest), last = next_in_triangle(next);
    const int others = is_sharp(next) + is_sharp(last);
    if (!is_sharp(longest) || others == 0 || !is_needle(t, squared_side(longest))) return {};
    return {longest, others == 2};
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

FeatureKind& kind_of(SurfaceFeatures& features, Index half_edge) {
  return features.kind[features.edges.edge_of[half_edge]];
}

/// A needle with a fold: one line along its two shorter sides. `longest`: half-edge.
void unfold(Index longest, SurfaceFeatures& features) {
  kind_of(features, longest) = FeatureKind::smooth;
  for (const Index side : {next_in_triangle(longest), prev_in_triangle(longest)})
    kind_of(features, side) = std::max(kind_of(features, side), FeatureKind::sharp);
}

/// Needles that would be faces join what is behind their longest sides.
void join_faces(const SurfaceMesh& mesh, std::span<const double> size, double angle,
                std::span<const Index> longest_sides, SurfaceFeatures& features) {
  const double least = cos_degrees(angle);
  const std::vector<Vec3> normals = triangle_normals(mesh, size);
  const auto is_bent = [&](Index e, Index side) {
    const Vec3 n = normals[triangle_of(mesh.twins[e])], m = normals[triangle_of(mesh.twins[side])];
    return dot(n, m) < least * length(n) * length(m);
  };
  for (const Index e : longest_sides) {
    const Index next = next_in_triangle(e), last = prev_in_triangle(e);
    if (is_bent(e, next) && is_bent(next, last) && is_bent(last, e)) continue;  // three faces
    kind_of(features, e) = FeatureKind::smooth;
    for (const Index side : {next, last})
      if (!is_bent(e, side)) kind_of(features, side) = FeatureKind::smooth;
  }
}

}  // namespace

void unfold_needles(const SurfaceMesh& mesh, std::span<const double> size,
                    std::span<const double> angles, const FeatureOptions& options,
                    SurfaceFeatures& features) {
  const NeedleFinder needles(mesh, size, features);
  const SharpChains chains(mesh, angles, options.angle, features);
  std::vector<Index> folds, faces;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [e, has_three] = needles.needle_at(t);
    if (e == none) continue;
    const bool rough = chains.is_rough(chains.through(features.edges.edge_of[e]), false);
    if (rough != has_three) (rough ? folds : faces).push_back(e);
  }
  for (const Index e : folds) unfold(e, features);
  if (!faces.empty()) join_faces(mesh, size, options.angle, faces, features);
}

}  // namespace lpq

#include "surface/sharp_edges.h"

#include <utility>
#include <vector>

#include "numerics/elementary.h"
#include "surface/normals.h"
#include "surface/sharp_chains.h"

namespace lpq {
namespace {

Vec3 direction(const SurfaceMesh& mesh, Index from, Index to) {
  const Vec3 d = mesh.points[to] - mesh.points[from];
  return (1 / length(d)) * d;
}

/// The edges by which a chain goes on from a loose end.
using Extension = std::vector<Index>;

/// Chains that go on where edges are less sharp.
class Extender {
 public:
  Extender(const SurfaceMesh& mesh, const FeatureOptions& options, std::span<const char> weak,
           SurfaceFeatures& features)
      : mesh_(mesh),
        features_(features),
        straight_(cos_degrees(options.corner_angle)),
        weak_at_(edges_at_vertices(features.edges, mesh.vertex_count(), weak)),
        valence_(mesh.points.size(), 0) {
    for (Index i = 0; i < features.edges.count(); ++i) {
      if (!features.is_feature(i)) continue;
      for (const Index v : features.edges.ends[i]) ++valence_[v];
    }
  }

  /// On from the loose ends of these edges.
  std::vector<Extension> extend(const std::vector<Index>& edges) {
    std::vector<Extension> all;
    for (const Index i : edges)
      for (const Index v : features_.edges.ends[i])
        if (Extension one = extend(i, v); !one.empty()) all.push_back(std::move(one));
    return all;
  }

 private:
  Extension extend(Index edge, Index v) {
    Extension all;
    while (valence_[v] == 1) {
      const Index next = straight_ahead(edge, v);
      if (next == none) break;
      features_.kind[next] = FeatureKind::sharp;
      all.push_back(next);
      for (const Index end : features_.edges.ends[next]) ++valence_[end];
      edge = next;
      v = features_.edges.other_end(next, v);
    }
    return all;
  }

  Index straight_ahead(Index edge, Index v) const {
    const Vec3 ahead = direction(mesh_, features_.edges.other_end(edge, v), v);
    Index best = none;
    double best_cos = straight_;
    for (const Index i : weak_at_.row(v)) {
      if (features_.is_feature(i)) continue;
      const double cos = dot(ahead, direction(mesh_, v, features_.edges.other_end(i, v)));
      if (!(cos > best_cos)) continue;
      best = i;
      best_cos = cos;
    }
    return best;
  }

  const SurfaceMesh& mesh_;
  SurfaceFeatures& features_;
  double straight_;
  Csr<Index> weak_at_;
  std::vector<Index> valence_;  // #V  features at the vertex
};

/// Those with which a chain does not stand out any more go again.
void drop_rough(const SurfaceMesh& mesh, std::span<const double> angles,
                const FeatureOptions& options, const std::vector<Extension>& extensions,
                SurfaceFeatures& features) {
  const SharpChains chains(mesh, angles, options.angle, features);
  Extension rough;
  for (const Extension& one : extensions)
    if (chains.is_rough(chains.through(one[0]), false))
      rough.insert(rough.end(), one.begin(), one.end());
  for (const Index edge : rough) features.kind[edge] = FeatureKind::smooth;
}

}  // namespace

std::vector<double> edge_angles(const SurfaceMesh& mesh, std::span<const double> size,
                                const SurfaceEdges& edges) {
  const std::vector<Vec3> normals = triangle_normals(mesh, size);
  std::vector<double> angles(edges.ends.size(), 0);
  for (Index i = 0; i < edges.count(); ++i) {
    const auto around = edges.half_edges.row(i);
    if (around.size() != 2 || mesh.twins[around[0]] == none) continue;
    const Vec3 n = normals[triangle_of(around[0])], m = normals[triangle_of(around[1])];
    if (n == Vec3{} || m == Vec3{}) continue;
    angles[i] = arc_tangent(length(cross(n, m)), dot(n, m)) * (180 / pi);
  }
  return angles;
}

void mark_sharp_edges(std::span<const double> angles, const FeatureOptions& options,
                      SurfaceFeatures& features) {
  if (options.angle >= 180) return;  // folds are not sharper by rounding
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (features.kind[i] == FeatureKind::smooth && angles[i] > options.angle)
      features.kind[i] = FeatureKind::sharp;
}

void extend_sharp_chains(const SurfaceMesh& mesh, std::span<const double> angles,
                         const FeatureOptions& options, SurfaceFeatures& features) {
  const SharpChains chains(mesh, angles, options.angle, features);
  std::vector<char> weak(angles.size()), seen(angles.size());
  std::vector<Index> clean;
  for (Index i = 0; i < features.edges.count(); ++i) {
    weak[i] = angles[i] > options.angle * options.hysteresis;
    if (seen[i] || features.kind[i] != FeatureKind::sharp) continue;
    const SharpChain chain = chains.through(i);
    for (const Index edge : chain.edges) seen[edge] = 1;
    if (!chains.is_rough(chain, true))
      clean.insert(clean.end(), chain.edges.begin(), chain.edges.end());
  }
  drop_rough(mesh, angles, options, Extender(mesh, options, weak, features).extend(clean),
             features);
}

}  // namespace lpq

#include "surface/sharp_edges.h"

#include "numerics/elementary.h"
#include "surface/normals.h"

namespace lpq {
namespace {

Vec3 direction(const SurfaceMesh& mesh, Index from, Index to) {
  const Vec3 d = mesh.points[to] - mesh.points[from];
  return (1 / length(d)) * d;
}

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

  void run() {
    for (Index i = 0; i < features_.edges.count(); ++i) {
      if (features_.kind[i] != FeatureKind::sharp) continue;
      for (const Index v : features_.edges.ends[i]) extend(i, v);
    }
  }

 private:
  void extend(Index edge, Index v) {
    while (valence_[v] == 1) {
      const Index next = straight_ahead(edge, v);
      if (next == none) return;
      features_.kind[next] = FeatureKind::sharp;
      for (const Index end : features_.edges.ends[next]) ++valence_[end];
      edge = next;
      v = features_.edges.other_end(next, v);
    }
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

}  // namespace

double cos_degrees(double angle) { return sin_cos(angle * (pi / 180)).cos; }

void mark_sharp_edges(const SurfaceMesh& mesh, std::span<const double> size,
                      const FeatureOptions& options, SurfaceFeatures& features) {
  const std::vector<Vec3> normals = triangle_normals(mesh, size);
  constexpr double nothing_is = -2;  // rounding takes cosines of folds below -1
  const double sharp = options.angle < 180 ? cos_degrees(options.angle) : nothing_is;
  const double carries_on = cos_degrees(options.angle * options.hysteresis);
  std::vector<char> weak(features.kind.size(), 0);
  for (Index i = 0; i < features.edges.count(); ++i) {
    const auto around = features.edges.half_edges.row(i);
    if (features.kind[i] != FeatureKind::smooth || mesh.twins[around[0]] == none) continue;
    const Vec3 n = normals[triangle_of(around[0])], m = normals[triangle_of(around[1])];
    if (n == Vec3{} || m == Vec3{}) continue;
    weak[i] = dot(n, m) < carries_on;
    if (dot(n, m) < sharp) features.kind[i] = FeatureKind::sharp;
  }
  Extender(mesh, options, weak, features).run();
}

}  // namespace lpq

#include "surface/corners.h"

#include <algorithm>

#include "numerics/elementary.h"

namespace lpq {
namespace {

class CornerFinder {
 public:
  CornerFinder(const SurfaceMesh& mesh, std::span<const double> size, double corner_angle,
               SurfaceFeatures& features)
      : mesh_(mesh), size_(size), straight_(cos_degrees(corner_angle)), features_(features) {
    at_ = features.edges_at_vertices(mesh.vertex_count());
  }

  void run() {
    features_.corner = pinched_vertices(mesh_.triangles, features_.edges, mesh_.vertex_count());
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (!features_.corner[v] && !at_.row(v).empty()) features_.corner[v] = is_corner(v);
  }

 private:
  bool is_corner(Index v) const {
    const auto edges = at_.row(v);
    if (edges.size() != 2) return true;
    if (faces_on_edge(features_, edges[0]) != faces_on_edge(features_, edges[1])) return true;
    const Vec3 p = mesh_.points[v];
    const Vec3 a = mesh_.points[features_.edges.other_end(edges[0], v)];
    const Vec3 b = mesh_.points[features_.edges.other_end(edges[1], v)];
    // Jagged lines turn at every vertex; a corner is one from some distance, too.
    return turns(a, p, b) && turns(look_along(v, edges[0]), p, look_along(v, edges[1]));
  }

  bool turns(Vec3 a, Vec3 p, Vec3 b) const {
    return dot(p - a, b - p) < straight_ * length(p - a) * length(b - p);
  }

  /// The point half a mesh size along the curve that leaves v on `edge`, or its end.
  Vec3 look_along(Index v, Index edge) const {
    double left = 0.5 * size_[v];
    for (Index from = v;;) {
      const Index to = features_.edges.other_end(edge, from);
      const Vec3 a = mesh_.points[from], b = mesh_.points[to];
      const double step = distance(a, b);
      if (step >= left) return a + (left / step) * (b - a);
      const auto next = at_.row(to);
      if (next.size() != 2 || to == v) return b;
      left -= step;
      edge = next[0] == edge ? next[1] : next[0];
      from = to;
    }
  }

  const SurfaceMesh& mesh_;
  std::span<const double> size_;
  double straight_;
  SurfaceFeatures& features_;
  Csr<Index> at_;  // #V  features at the vertex
};

}  // namespace

std::vector<Index> faces_on_edge(const SurfaceFeatures& features, Index edge) {
  std::vector<Index> faces;
  for (const Index e : features.edges.half_edges.row(edge))
    faces.push_back(features.face[triangle_of(e)]);
  std::sort(faces.begin(), faces.end());
  return faces;
}

void mark_corners(const SurfaceMesh& mesh, std::span<const double> size, double corner_angle,
                  SurfaceFeatures& features) {
  CornerFinder(mesh, size, corner_angle, features).run();
}

}  // namespace lpq

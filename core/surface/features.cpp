#include "surface/features.h"

#include <utility>

#include "base/check.h"
#include "surface/bends.h"
#include "surface/components.h"
#include "surface/corners.h"
#include "surface/needles.h"
#include "surface/sharp_edges.h"
#include "surface/short_chains.h"
#include "surface/size_field.h"

namespace lpq {
namespace {

void mark_hard_edges(const SurfaceMesh& mesh, const FeatureOptions& options,
                     SurfaceFeatures& features) {
  const SurfaceEdges& edges = features.edges;
  for (Index i = 0; i < edges.count(); ++i) {
    const auto around = edges.half_edges.row(i);
    if (around.size() != 2 || mesh.twins[around[0]] == none) {
      features.kind[i] = FeatureKind::wall;
    } else if (options.groups &&
               mesh.group[triangle_of(around[0])] != mesh.group[triangle_of(around[1])]) {
      features.kind[i] = FeatureKind::group_border;
    }
  }
}

}  // namespace

std::vector<char> SurfaceFeatures::half_edges() const {
  std::vector<char> on(edges.edge_of.size());
  for (std::size_t e = 0; e < on.size(); ++e) on[e] = half_edge_is_feature(static_cast<Index>(e));
  return on;
}

Csr<Index> SurfaceFeatures::edges_at_vertices(Index vertex_count) const {
  std::vector<char> flags(kind.size());
  for (Index i = 0; i < edges.count(); ++i) flags[i] = is_feature(i);
  return lpq::edges_at_vertices(edges, vertex_count, flags);
}

void number_faces(const SurfaceMesh& mesh, SurfaceFeatures& features) {
  Components faces = components_of(mesh.twins, features.half_edges());
  features.face = std::move(faces.of_triangle);
  features.face_count = faces.count;
}

SurfaceFeatures find_features(const SurfaceMesh& mesh, std::span<const double> given_size,
                              const FeatureOptions& options) {
  LPQ_ASSERT(given_size.size() == mesh.points.size());
  // A quad that is larger than what it is of says nothing about what is noise there.
  std::vector<double> size(given_size.begin(), given_size.end());
  limit_to_parts(mesh, 0.25, size);
  SurfaceFeatures features;
  features.edges = surface_edges(mesh.triangles, mesh.vertex_count());
  features.kind.assign(features.edges.ends.size(), FeatureKind::smooth);
  mark_hard_edges(mesh, options, features);
  const std::vector<double> angles = edge_angles(mesh, size, features.edges);
  mark_sharp_edges(angles, options, features);
  drop_short_chains(mesh, size, angles, options, features);
  // Only now, so that chains divide no others on their way.
  extend_sharp_chains(mesh, angles, options, features);
  drop_small_heaps(mesh, size, angles, options, features);
  unfold_needles(mesh, size, angles, options, features);
  number_faces(mesh, features);
  mark_corners(mesh, size, options.corner_angle, features);
  mark_bends(mesh, size, options.bend_angle, features);
  return features;
}

}  // namespace lpq

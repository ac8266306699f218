// See tips.h.
#include "surface/tips.h"

#include <cmath>

#include "numerics/elementary.h"
#include "surface/fans.h"

namespace lpq {
namespace {

// Round so much there may be one quad, though a bad one.
constexpr double slender = 160 * pi / 180;

/// The edge that halves a fan's angle best; none if that is large.
Index middle_edge(const SurfaceMesh& mesh, std::span<const Index> corners) {
  double all = 0;
  for (const Index e : corners) all += corner_angle(mesh, e);
  if (all > slender) return none;
  Index middle = none;
  double before = 0, least = all;
  for (const Index e : corners.first(corners.size() - 1)) {
    before += corner_angle(mesh, e);
    const double off = std::abs(before - 0.5 * all);
    if (off >= least) continue;
    least = off;
    middle = prev_in_triangle(e);
  }
  return middle;
}

}  // namespace

void mark_tips(const SurfaceMesh& mesh, SurfaceFeatures& features) {
  const SurfaceFans fans = fans_of(mesh.twins, features.half_edges());
  const std::vector<Index>& edge_of = features.edges.edge_of;
  for (Index f = 0; f < fans.count(); ++f) {
    const auto corners = fans.corners.row(f);
    if (fans.closed[f] || edge_of[corners.front()] != edge_of[prev_in_triangle(corners.back())])
      continue;
    const Index middle = middle_edge(mesh, corners);
    if (middle == none) continue;
    features.kind[edge_of[middle]] = FeatureKind::marked;
    for (const Index v : features.edges.ends[edge_of[middle]]) features.corner[v] = 1;
  }
  number_faces(mesh, features);
}

}  // namespace lpq

#include "surface/fans.h"

#include "numerics/elementary.h"

namespace lpq {

SurfaceFans fans_of(std::span<const Index> twins, std::span<const char> barrier) {
  const auto blocked = [&](Index e) {
    return twins[e] == none || (!barrier.empty() && barrier[e]);
  };
  SurfaceFans fans;
  fans.of_corner.assign(twins.size(), none);
  fans.corners.values.reserve(twins.size());
  for (Index e = 0; e < static_cast<Index>(twins.size()); ++e) {
    if (fans.of_corner[e] != none) continue;
    Index first = e;
    while (!blocked(first)) {
      first = next_in_triangle(twins[first]);
      if (first == e) break;
    }
    fans.closed.push_back(!blocked(first));
    for (Index corner = first;;) {
      fans.of_corner[corner] = fans.count();
      fans.corners.values.push_back(corner);
      const Index left = prev_in_triangle(corner);
      if (blocked(left) || twins[left] == first) break;
      corner = twins[left];
    }
    fans.corners.end_row();
  }
  return fans;
}

double corner_angle(const SurfaceMesh& mesh, Index e) {
  const Vec3 p = mesh.points[mesh.origin(e)];
  const Vec3 a = mesh.points[mesh.target(e)] - p, b = mesh.points[mesh.apex(e)] - p;
  return arc_tangent(length(cross(a, b)), dot(a, b));
}

}  // namespace lpq

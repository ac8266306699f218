#include "recombine/fans.h"

#include "mesh/ideal_quads.h"
#include "mesh/walk.h"
#include "numerics/elementary.h"

namespace lpq {
namespace {

double corner_angle(const TriMesh& mesh, Index e) {
  const Vec2 v = mesh.points[mesh.origin(e)];
  const Vec2 along = mesh.points[mesh.target(e)] - v, back = mesh.points[mesh.apex(e)] - v;
  return arc_tangent(cross(along, back), dot(along, back));
}

/// Gives the fan that starts at `first` the next number.
void add_fan(const TriMesh& mesh, Index first, bool closed, Fans& fans) {
  Fan fan{.first = first, .closed = closed};
  double angle = 0;
  for_each_in_fan(mesh, first, [&](Index e) {
    fans.of_corner[e] = static_cast<Index>(fans.list.size());
    fan.last = e;
    ++fan.triangles;
    if (!closed) angle += corner_angle(mesh, e);
  });
  if (!closed) fan.ideal = ideal_quads(angle);
  fans.list.push_back(fan);
}

}  // namespace

Fans find_fans(const TriMesh& mesh) {
  Fans fans;
  const Index half_edges = 3 * mesh.triangle_count();
  fans.of_corner.assign(static_cast<std::size_t>(half_edges), none);
  for (Index e = 0; e < half_edges; ++e)
    if (mesh.twins[e] == none) add_fan(mesh, e, false, fans);
  for (Index e = 0; e < half_edges; ++e)
    if (fans.of_corner[e] == none) add_fan(mesh, e, true, fans);
  return fans;
}

}  // namespace lpq

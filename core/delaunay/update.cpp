// Repair after the free vertices have moved: as long as no triangle has turned over, the triangles
// still tile the domain, and flipping edges with an occupied circle ends in the constrained
// Delaunay triangulation [Lawson 1977]. Both scans are pure floating filters in the common case;
// only suspects reach the stack. Cost O(#T) plus the flips.
#include <algorithm>

#include "delaunay/delaunay.h"
#include "geometry/predicates_inline.h"

namespace lpq {
namespace {

bool all_counter_clockwise(const TriMesh& mesh) {
  const Vec2* p = mesh.points.data();
  for (const Tri& t : mesh.triangles) {
    if (orient2d_inline(p[t[0]], p[t[1]], p[t[2]]) <= 0) return false;
  }
  return true;
}

bool occupied(const TriMesh& mesh, Index e, Index twin) {
  const Tri& t = mesh.triangles[triangle_of(e)];
  const Vec2* p = mesh.points.data();
  return in_circle_inline(p[t[0]], p[t[1]], p[t[2]], p[mesh.apex(twin)]) > 0;
}

}  // namespace

UpdateResult update(TriMesh& mesh, std::span<const Vec2> interior, UpdateWorkspace* workspace) {
  LPQ_ASSERT(mesh.points.size() == mesh.fixed + interior.size());
  std::copy(interior.begin(), interior.end(), mesh.points.begin() + mesh.fixed);
  UpdateResult result;
  if (!all_counter_clockwise(mesh)) {
    result.status = UpdateStatus::needs_rebuild;
    return result;
  }
  UpdateWorkspace own;
  std::vector<Index>& suspects = workspace != nullptr ? workspace->suspects : own.suspects;
  suspects.clear();
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Index twin = mesh.twins[e];
    if (e < twin && occupied(mesh, e, twin)) suspects.push_back(e);
  }
  while (!suspects.empty()) {
    const Index e = suspects.back();
    suspects.pop_back();
    const Index f = mesh.twins[e];
    if (f == none || !occupied(mesh, e, f)) continue;
    flip_edge(corners_of(mesh.triangles), mesh.twins.data(), e);
    ++result.flips;
    for (const Index h : {e, f, next_in_triangle(f), prev_in_triangle(e)}) suspects.push_back(h);
  }
  return result;
}

}  // namespace lpq

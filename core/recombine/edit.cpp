#include "recombine/edit.h"

#include "geometry/predicates.h"

namespace lpq {
namespace {

void link(TriMesh& mesh, Index e, Index twin) {
  mesh.twins[e] = twin;
  if (twin != none) mesh.twins[twin] = e;
}

}  // namespace

bool is_flippable(const TriMesh& mesh, Index e) {
  const Index twin = mesh.twins[e];
  if (twin == none) return false;
  const Vec2 a = mesh.points[mesh.origin(e)], b = mesh.points[mesh.target(e)];
  const Vec2 left = mesh.points[mesh.apex(e)], right = mesh.points[mesh.apex(twin)];
  return orient2d(left, a, right) > 0 && orient2d(right, b, left) > 0;
}

//        left                left
//       / t  \              / | \        t  = (a, right, left)
//      a --e-- b    ->     a  |  b
//       \ s  /              \ | /        s  = (b, left, right)
//        right               right
void flip_edge(TriMesh& mesh, Index e) {
  const Index twin = mesh.twins[e];
  LPQ_ASSERT(twin != none);
  const Index t = triangle_of(e), s = triangle_of(twin);
  const Index a = mesh.origin(e), b = mesh.target(e);
  const Index left = mesh.apex(e), right = mesh.apex(twin);
  const Index b_left = mesh.twins[next_in_triangle(e)], left_a = mesh.twins[prev_in_triangle(e)];
  const Index a_right = mesh.twins[next_in_triangle(twin)];
  const Index right_b = mesh.twins[prev_in_triangle(twin)];
  mesh.triangles[t] = {a, right, left};
  mesh.triangles[s] = {b, left, right};
  link(mesh, 3 * t, a_right);
  link(mesh, 3 * t + 1, 3 * s + 1);
  link(mesh, 3 * t + 2, left_a);
  link(mesh, 3 * s, b_left);
  link(mesh, 3 * s + 2, right_b);
}

void split_triangle(TriMesh& mesh, Index t) {
  const Tri corner = mesh.triangles[t];
  const Index outside[3] = {mesh.twins[3 * t], mesh.twins[3 * t + 1], mesh.twins[3 * t + 2]};
  const Index center = mesh.vertex_count();
  const Index part[3] = {t, mesh.triangle_count(), mesh.triangle_count() + 1};
  mesh.points.push_back((1.0 / 3) *
                        (mesh.points[corner[0]] + mesh.points[corner[1]] + mesh.points[corner[2]]));
  mesh.triangles.resize(mesh.triangles.size() + 2);
  mesh.twins.resize(mesh.twins.size() + 6, none);
  mesh.region.resize(mesh.region.size() + 2, mesh.region[t]);
  for (int k = 0; k < 3; ++k) {
    mesh.triangles[part[k]] = {corner[k], corner[(k + 1) % 3], center};
    link(mesh, 3 * part[k], outside[k]);
    link(mesh, 3 * part[k] + 1, 3 * part[(k + 1) % 3] + 2);
  }
}

}  // namespace lpq

// A triangulated surface in space as flat arrays. As in TriMesh, a wall is a half-edge without a
// twin; a surface is orientable and manifold across the twins it has, whatever the input was: where
// it was not, there are walls. Points are shared across walls, so a curve is stored once.
#pragma once

#include <vector>

#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct SurfaceMesh {
  std::vector<Vec3> points;    // #V
  std::vector<Tri> triangles;  // #T  counter-clockwise seen from outside
  std::vector<Index> twins;    // 3 #T  half-edge on the other side, none at a wall
  std::vector<Index> group;    // #T  group of the file (a face of the CAD model), 0 if it has none
  std::vector<Index> body;     // #V  body of the file, touching others perhaps; empty: there is one

  Index body_of(Index v) const { return body.empty() ? 0 : body[v]; }
  Index vertex_count() const { return static_cast<Index>(points.size()); }
  Index triangle_count() const { return static_cast<Index>(triangles.size()); }
  Index origin(Index e) const { return corners_of(triangles)[e]; }
  Index target(Index e) const { return origin(next_in_triangle(e)); }
  Index apex(Index e) const { return origin(prev_in_triangle(e)); }
};

inline double triangle_area(const SurfaceMesh& mesh, Index t) {
  const auto [a, b, c] = mesh.triangles[t];
  const Vec3 corner = mesh.points[a];
  return 0.5 * length(cross(mesh.points[b] - corner, mesh.points[c] - corner));
}

}  // namespace lpq

// Certificates of a (constrained) Delaunay triangulation, by exact predicates only.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "geometry/predicates.h"
#include "geometry/predicates_inline.h"
#include "mesh/tri_mesh.h"
#include "support/delaunay_boundary.h"

namespace lpq_test {

using lpq::TriMesh;

/// Edges without a wall whose two triangles do not have empty circles. None means constrained
/// Delaunay, since the local property implies the global one.
inline int occupied_edges(const TriMesh& mesh) {
  int count = 0;
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    if (mesh.twins[e] == none) continue;
    const auto& [a, b, c] = mesh.triangles[lpq::triangle_of(e)];
    count += lpq::in_circle_inline(mesh.points[a], mesh.points[b], mesh.points[c],
                                   mesh.points[mesh.apex(mesh.twins[e])]) > 0;
  }
  return count;
}

/// The definition itself, O(#T #V): pairs of a triangle and a vertex strictly inside its circle.
inline int occupied_circles(const TriMesh& mesh) {
  int count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const Vec2 p : mesh.points) {
      count += lpq::in_circle_inline(mesh.points[a], mesh.points[b], mesh.points[c], p) > 0;
    }
  }
  return count;
}

inline double mesh_area(const TriMesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    twice += cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  }
  return twice / 2;
}

inline double boundary_area(const BoundaryMesh& boundary) {
  double twice = 0;
  for (const lpq::Segment& s : boundary.edges) {
    const double strip = cross(boundary.points[s.a], boundary.points[s.b]);
    if (s.left != none) twice += strip;
    if (s.right != none) twice -= strip;
  }
  return twice / 2;
}

/// Twice the exact area of a triangulation of integer points.
inline std::int64_t integer_twice_area(const TriMesh& mesh) {
  std::int64_t twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    twice += static_cast<std::int64_t>(
        cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
  }
  return twice;
}

/// The directed walls, sorted: what `boundary.edges` must become on the sides that have a region.
inline std::vector<std::array<Index, 2>> walls_of(const TriMesh& mesh) {
  std::vector<std::array<Index, 2>> walls;
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    if (mesh.twins[e] == none) walls.push_back({mesh.origin(e), mesh.target(e)});
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

inline std::vector<std::array<Index, 2>> expected_walls(const BoundaryMesh& boundary) {
  std::vector<std::array<Index, 2>> walls;
  for (const lpq::Segment& s : boundary.edges) {
    if (s.left != none) walls.push_back({s.a, s.b});
    if (s.right != none) walls.push_back({s.b, s.a});
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

/// The same triangles, regions and walls, whatever their order?
inline bool same_triangulation(const TriMesh& a, const TriMesh& b) {
  const TriMesh p = lpq::canonical(a), q = lpq::canonical(b);
  return p.triangles == q.triangles && p.twins == q.twins && p.region == q.region;
}

/// Vertex i becomes vertex number[i].
inline TriMesh renumbered(TriMesh mesh, const std::vector<Index>& number) {
  const std::vector<Vec2> points = mesh.points;
  for (std::size_t i = 0; i < points.size(); ++i) mesh.points[number[i]] = points[i];
  for (lpq::Tri& t : mesh.triangles) {
    for (Index& v : t) v = number[v];
  }
  return mesh;
}

/// Random points inside the domain, at least `gap` from every boundary node; deterministic.
inline std::vector<Vec2> points_inside(const BoundaryMesh& boundary, int count, std::uint64_t seed,
                                       double gap) {
  Vec2 lo = boundary.points[0], hi = lo;
  for (const Vec2 p : boundary.points) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  lpq::Rng rng(seed);
  std::vector<Vec2> inside;
  while (static_cast<int>(inside.size()) < count) {
    const Vec2 p{rng.between(lo.x, hi.x), rng.between(lo.y, hi.y)};
    int winding = 0;
    bool near = false;
    for (const lpq::Segment& s : boundary.edges) {
      const Vec2 a = boundary.points[s.a], b = boundary.points[s.b];
      near = near || squared_length(p - a) < gap * gap;
      if (s.left != none && s.right != none) continue;
      if ((a.y <= p.y) != (b.y <= p.y)) {
        const int side = lpq::orient2d(a, b, p);
        winding += b.y > a.y ? (side > 0) : -(side < 0);
      }
    }
    if (winding == 1 && !near) inside.push_back(p);
  }
  return inside;
}

}  // namespace lpq_test

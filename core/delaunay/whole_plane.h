// The triangulation under construction: triangles plus one ghost triangle per hull edge, whose
// corner at infinity is `none`, so that every half-edge has a twin and the hull needs no special
// cases [Guibas, Stolfi 1985; Shewchuk 1997]. Shared by the three steps of a build: Delaunay
// insertion, constraint insertion, carving. Vertices are numbered along a Hilbert curve.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "domain/domain.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct WholePlane {
  std::vector<Vec2> points;         // #V  along the curve
  std::vector<Index> given;         // #V  number of the vertex as given
  std::vector<Tri> triangles;       // #T  a corner none = the vertex at infinity
  std::vector<Index> twins;         // 3 #T  always set
  std::vector<unsigned char> wall;  // 3 #T  1 on both sides of a constraint; empty: no constraints

  Index triangle_count() const { return static_cast<Index>(triangles.size()); }
  Index origin(Index e) const { return corners_of(triangles)[e]; }
  Index target(Index e) const { return origin(next_in_triangle(e)); }
  Index apex(Index e) const { return origin(prev_in_triangle(e)); }
  /// Next half-edge counter-clockwise around the origin of e.
  Index rotated(Index e) const { return twins[prev_in_triangle(e)]; }
  void link(Index e, Index twin) {
    twins[e] = twin;
    twins[twin] = e;
  }
  bool is_ghost(Index t) const {
    const Tri& c = triangles[t];
    return c[0] == none || c[1] == none || c[2] == none;
  }
};

/// Delaunay triangulation of distinct points; `points` and `given` must be set, `insertion` is a
/// permutation. Expected cost O(n log n), close to linear.
Problem insert_all(WholePlane& plane, std::span<const Index> insertion);

/// Forces the segments (in vertex numbers of the caller) and marks them as walls; the result is the
/// constrained Delaunay triangulation. `fixed`: caller's vertices below are the boundary's.
Problem insert_segments(WholePlane& plane, std::span<const Segment> segments, Index fixed);

/// Labels triangles with the region of the segment side they are reached from, drops those of no
/// region, cuts at walls, and numbers vertices as the caller does. The result has no points yet.
TriMesh carve(WholePlane&& plane, std::span<const Segment> segments);

/// All triangles of the convex hull, region 0; no points yet.
TriMesh without_ghosts(WholePlane&& plane);

/// A half-edge leaving each vertex.
std::vector<Index> leaving_half_edges(const WholePlane& plane);

/// The half-edge a->b, none if there is no such edge. Cost: degree of a.
Index find_edge(const WholePlane& plane, std::span<const Index> leaving, Index a, Index b);

/// The inverse of `given`.
std::vector<Index> vertex_numbers(const WholePlane& plane);

}  // namespace lpq

// The clipped Voronoi diagram in the form the energy wants: one entry per Delaunay edge instead of
// one polygon per cell. Away from walls nothing is stored but the circumcentres; what a wall
// touches (the rim) is listed.
//
// Clipping (paper section 3.1.3) on a *constrained* Delaunay triangulation. Its dual is Seidel's
// bounded Voronoi diagram [Seidel 1988]: behind every wall lies a half-plane of its own, glued to
// the domain along the wall, and every circumcentre outside the domain lies behind exactly one
// wall. The triangles whose circumcentres lie behind wall w form a tree that grows from the
// triangle at w through its neighbours (the propagation of section 3.1.2); the outline of that
// tree, read from one end of w to the other, is the sequence of cells that meet w. Cutting those
// cells by the half-plane (Sutherland-Hodgman, section 3.1.3) puts one vertex on w for every
// outline edge: the point where the bisector of its two sites crosses w. Interior walls, corners,
// holes and cells cut by several walls need no case of their own.
//
// Whatever the circumcentres' rounding does to the trees, the signed areas still add up to the
// domain's: each triangle contributes a closed sum, and each wall vertex lies on its wall. Cost
// O(#T).
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "mesh/tri_mesh.h"

namespace lpq {

enum class VertexKind : std::uint8_t {
  three_bisectors,    // circumcentre of a Delaunay triangle (paper Fig. 15)
  bisector_and_wall,  // bisector of two sites meets a wall (Figs. 16, 17)
  corner,             // a fixed vertex of the 1D mesh, or a point depending on no free site
};

/// Part of a cell: triangle (site, c1, c2), counter-clockwise. All of them tile the domain.
struct FanTriangle {
  Index site = none;
  Index c1 = none, c2 = none;  // Voronoi vertices
};

/// A Voronoi vertex on a wall.
struct RimVertex {
  VertexKind kind = VertexKind::corner;
  Index u = none, v = none;  // the two sites whose bisector it is on
  Index wall = none;         // wall half-edge
};

struct ClippedDual {
  /// In `end`: the whole dual edge lies behind a wall.
  static constexpr Index beyond = -2;
  /// In `sheet`: the circumcentre was replaced by the midpoint of the longest edge.
  static constexpr Index replaced = -2;

  std::vector<Vec2> vertices;     // #T circumcentres (meaningless where sheet != none), then #rim
  std::vector<RimVertex> rim;     // #rim
  std::vector<Index> sheet;       // #T  wall half-edge behind which the circumcentre lies, or none
  std::vector<Index> end;         // 3 #T  vertex that ends the dual edge on this half-edge's side:
                                  //       none = the triangle's circumcentre, or a rim vertex
  std::vector<FanTriangle> fans;  // fan triangles with a vertex on the rim
  Index clamped_crossings = 0;    // bisectors (nearly) parallel to their wall, put at a wall's end
  Index replaced_centres = 0;     // circumcentres that rounding drove out of the domain

  /// Half-edge e carries an undivided dual edge, counted once for the two half-edges. Its fan
  /// triangles are (origin, right, left) and (target, left, right), where left is the circumcentre
  /// of e's own triangle.
  bool is_regular(Index e, Index twin) const {
    return twin > e && end[e] == none && end[twin] == none;
  }

  std::vector<Index> walls, chain, stack;  // scratch
};

/// Fills `dual` (its memory is reused). `mesh` is a constrained Delaunay triangulation.
void clip_dual(const TriMesh& mesh, ClippedDual& dual);

/// Circumcentre, computed relative to a.
Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c);

}  // namespace lpq

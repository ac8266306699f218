// Point location by walking from a remembered triangle; a grid of triangle lists catches the walks
// that run into a wall, so that no query is ever exhaustive.
#pragma once

#include <vector>

#include "base/csr.h"
#include "domain/box_tree.h"
#include "geometry/predicates_inline.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Is p in the closed triangle? Exact.
inline bool contains(const TriMesh& mesh, Index t, Vec2 p) {
  const Tri& c = mesh.triangles[t];
  const Vec2 a = mesh.points[c[0]], b = mesh.points[c[1]], d = mesh.points[c[2]];
  return orient2d_inline(a, b, p) >= 0 && orient2d_inline(b, d, p) >= 0 &&
         orient2d_inline(d, a, p) >= 0;
}

/// Triangle whose closure contains p, walking from triangle `hint` (any valid triangle, or none).
/// Returns none when p is outside the mesh; walks around walls by falling back to an exhaustive
/// search only when the straight walk is blocked, so keep hints near. Exact signs.
Index locate(const TriMesh& mesh, Vec2 p, Index hint);

/// A grid with the triangles that meet each cell, and a tree of those at the border; about O(#T) to
/// build.
class Locator {
 public:
  Locator() = default;
  explicit Locator(const TriMesh& mesh);
  /// Triangle that contains p, or none. `hint` is read and updated; none asks the grid.
  Index find(Vec2 p, Index& hint) const {
    if (hint != none && contains(*mesh_, hint, p)) return hint;
    return find_elsewhere(p, hint);
  }
  /// Like find, but the nearest triangle when p is outside or on a rounding-error rim.
  Index find_nearest(Vec2 p, Index& hint) const {
    const Index t = find(p, hint);
    return t != none ? t : nearest(p, hint);
  }

 private:
  Index find_elsewhere(Vec2 p, Index& hint) const;
  Index nearest(Vec2 p, Index& hint) const;
  void find_border();
  Index column_of(double x) const;
  Index row_of(double y) const;
  /// Calls visit(cell) for every cell that the triangle may meet.
  template <class Visit>
  void for_cells_of(Index t, const Visit& visit) const;

  const TriMesh* mesh_ = nullptr;
  Vec2 origin_, corner_;  // of the grid's box
  double cell_ = 1;
  Index columns_ = 0, rows_ = 0;
  Csr<Index> near_;            // columns x rows  triangles that meet the cell
  std::vector<Index> border_;  // triangles with an edge there
  BoxTree border_boxes_;       // of those
};

}  // namespace lpq

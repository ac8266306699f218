// A part of a surface cut open: its triangles with a vertex numbering of their own, in which a
// surface vertex appears once per fan of corners, and its borders as loops.
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct Part {
  std::vector<Index> triangles;  // #T  of the surface, ascending
  std::vector<Tri> corners;      // #T  own vertices
  std::vector<Index> twins;      // 3 #T  own half-edges, none at the border
  std::vector<Index> vertex;     // #V  of the surface
  std::vector<double> length;    // 3 #T  of half-edges
  Csr<Index> loops;              // border half-edges, each loop in order; the longest loop first

  Index vertex_count() const { return static_cast<Index>(vertex.size()); }
  Index triangle_count() const { return static_cast<Index>(triangles.size()); }
  Index origin(Index e) const { return corners_of(corners)[e]; }
  Index target(Index e) const { return origin(next_in_triangle(e)); }
  Index apex(Index e) const { return origin(prev_in_triangle(e)); }
  /// Half-edge of the surface that own half-edge e is.
  Index on_surface(Index e) const { return 3 * triangles[triangle_of(e)] + e % 3; }
  /// 2 - 2 genus - #loops, for a part in one piece.
  Index euler() const {
    return vertex_count() - (3 * triangle_count() + loops.offsets.back()) / 2 + triangle_count();
  }
  Index genus() const { return (2 - euler() - loops.rows()) / 2; }
};

/// Takes parts out of one surface; keeps a table of the surface's size between calls.
class PartTaker {
 public:
  explicit PartTaker(const SurfaceMesh& mesh) : mesh_(mesh), own_(mesh.triangles.size(), none) {}
  /// `cut` marks half-edges (both sides) that the part does not hang together across.
  Part take(std::vector<Index> triangles, std::span<const char> cut);

 private:
  const SurfaceMesh& mesh_;
  std::vector<Index> own_;  // #T of the surface, none outside calls
};

/// Sum of the lengths of the border half-edges of a loop.
double loop_length(const Part& part, Index loop);

}  // namespace lpq

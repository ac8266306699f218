// Editable connectivity over a QuadMesh: faces may be added and removed, vertices added; what died
// is swept out by compact(). Fixed vertices (the 1D mesh) keep their numbers and positions for
// ever, and an edge of the 1D mesh (outer boundary or wall) can be asked for but never edited.
// Every query looks only at the faces of one vertex, so an edit costs O(valence).
#pragma once

#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/quad_mesh.h"

namespace lpq {

class QuadTopology {
 public:
  explicit QuadTopology(QuadMesh mesh);

  /// The mesh without dead faces and unused free vertices; the order of the living is kept.
  QuadMesh compact() &&;

  Index vertex_count() const { return static_cast<Index>(mesh_.points.size()); }
  Index face_slots() const { return static_cast<Index>(mesh_.faces.size()); }  // dead ones too
  bool is_fixed(Index v) const { return v < mesh_.fixed; }
  bool is_alive(Index f) const { return mesh_.faces[f][0] != none; }
  Vec2 point(Index v) const { return mesh_.points[v]; }
  const std::vector<Vec2>& points() const { return mesh_.points; }
  const Face& face(Index f) const { return mesh_.faces[f]; }
  Index region(Index f) const { return mesh_.region.empty() ? 0 : mesh_.region[f]; }
  std::span<const Index> faces_of(Index v) const { return faces_of_[v]; }
  Index valence(Index v) const { return static_cast<Index>(faces_of_[v].size()); }
  /// Quads at v outside a mesh that is part of a larger one; none where that does not count.
  Index outside(Index v) const {
    return v < static_cast<Index>(mesh_.outside.size()) ? mesh_.outside[v] : none;
  }

  /// Constraint edge between two fixed vertices with faces on both sides.
  bool is_wall(Index a, Index b) const;
  /// The face that has the directed edge a -> b, or none.
  Index face_with_edge(Index a, Index b) const;

  void move(Index v, Vec2 position);  // free vertices only
  Index add_vertex(Vec2 position);
  Index add_face(const Face& face, Index region);
  void remove_face(Index f);

 private:
  QuadMesh mesh_;
  std::vector<std::vector<Index>> faces_of_;  // #V
};

/// Slot of vertex v in the face, none if it is no corner.
Index corner_of(const Face& face, Index v);
/// The corners before and after slot k (3 or 4 corners), counter-clockwise.
inline Index next_corner(const Face& face, Index k) { return face[(k + 1) % corner_count(face)]; }
inline Index prev_corner(const Face& face, Index k) {
  const Index n = corner_count(face);
  return face[(k + n - 1) % n];
}

/// Faces around every vertex of a plain mesh, in ascending order: one row per vertex.
Csr<Index> faces_at_vertices(const QuadMesh& mesh);

/// Every corner a strict left turn, by exact signs and by more than coordinates of the unit frame
/// are rounded: the face is strictly convex, and stays so in the caller's coordinates.
bool is_strictly_convex(std::span<const Vec2> points, const Face& face);

}  // namespace lpq

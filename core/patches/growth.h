// A growing set of faces that is to become a patch: a disk of quads (and of pairs of triangles,
// where these may be mended, too) without fixed vertices or walls inside, whose outline bends
// outwards only. Where it would bend inwards the missing faces are added; so the irregular vertices
// on the rim are always mended from inside.
#pragma once

#include "cleanup/ideal_valence.h"
#include "cleanup/quad_topology.h"

namespace lpq {

/// The rim of a patch and what its irregularity is now.
struct PatchOutline {
  std::vector<Index> loop;  // counter-clockwise, beginning at a corner
  std::vector<Index>
      corner;  // ascending positions in `loop` that will have one quad, the first is 0
  std::vector<Index> inside;  // vertices strictly inside
  double weight = 0;          // irregularity of all these vertices
  double rim_weight = 0;      // what the loop's will be if every other loop vertex gets two quads
};

class PatchGrowth {
 public:
  PatchGrowth(const QuadTopology& mesh, const IdealValence& ideal, bool takes_triangles = false);

  void clear();
  void add_face(Index f);
  /// The faces at v; of a fixed vertex on a wall inside the domain, none: its sides are apart.
  void add_star(Index v);
  void add_ring();
  /// Adds faces until the rim bends outwards everywhere. False when that needs more than `limit`
  /// faces, or a triangle that it may not take, or crosses a wall: the patch is beyond repair,
  /// however it grows.
  bool close(Index limit);
  /// The rim; false while the faces are not a disk, bend inwards at a fixed vertex, or hold an odd
  /// number of triangles.
  bool outline(PatchOutline& result) const;

  const std::vector<Index>& faces() const { return faces_; }
  Index triangles() const { return triangles_; }
  bool contains(Index f) const { return inside_[f] != 0; }

 private:
  struct Rim {
    Index face = none;  // of the patch, at the vertex
    Index next = none;  // vertex
  };
  bool bends_inwards(Index v) const;
  Rim rim_after(Index v, Index f) const;
  bool walk(std::vector<Index>& loop, std::vector<Index>& face) const;
  void add_faces_beside(Index v);

  const QuadTopology& mesh_;
  const IdealValence& ideal_;
  std::vector<char> inside_;  // #face slots
  std::vector<Index> count_;  // #V  faces of the patch at each vertex
  std::vector<Index> faces_, vertices_;
  std::vector<Index> unchecked_;       // vertices whose bend may be inwards
  mutable std::vector<char> on_loop_;  // #V scratch
  const bool takes_triangles_;
  Index triangles_ = 0;  // of the faces
  bool broken_ = false;  // a triangle that it may not take, or a wall inside
};

}  // namespace lpq

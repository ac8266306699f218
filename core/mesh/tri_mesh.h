// Triangulations as flat arrays. A wall is a half-edge without a twin: the outer boundary, a hole,
// and also both sides of every constraint edge inside, so that no stage can cross one by accident.
#pragma once

#include <array>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

using Tri = std::array<Index, 3>;  // counter-clockwise
static_assert(sizeof(Tri) == 3 * sizeof(Index));

/// Triangles as one array of corners: corner e is the origin of half-edge e.
inline const Index* corners_of(const std::vector<Tri>& triangles) {
  return reinterpret_cast<const Index*>(triangles.data());
}
inline Index* corners_of(std::vector<Tri>& triangles) {
  return reinterpret_cast<Index*>(triangles.data());
}

/// Replaces the edge of e by the other diagonal of its two triangles. Before: e = a->b with apex c,
/// its twin f = b->a with apex d. After: e = a->d and f = d->b, both with apex c, while c->a and
/// b->c are prev(e) and next(f).
inline void flip_edge(Index* corners, Index* twins, Index e) {
  const auto link = [twins](Index h, Index twin) {
    twins[h] = twin;
    if (twin != none) twins[twin] = h;
  };
  const Index f = twins[e];
  const Index en = next_in_triangle(e), ep = prev_in_triangle(e);
  const Index fn = next_in_triangle(f), fp = prev_in_triangle(f);
  const Index b = corners[f], c = corners[ep], d = corners[fp];
  const Index beyond_ad = twins[fn], beyond_db = twins[fp], beyond_bc = twins[en];
  corners[en] = d;
  corners[f] = d;
  corners[fn] = b;
  corners[fp] = c;
  link(e, beyond_ad);
  link(f, beyond_db);
  link(fn, beyond_bc);
  link(en, fp);
}

struct TriMesh {
  std::vector<Vec2> points;    // #V  unit-frame coordinates; 0 .. fixed-1 never move
  std::vector<Tri> triangles;  // #T
  std::vector<Index> twins;    // 3 #T  half-edge on the other side, none at a wall
  std::vector<Index> region;   // #T  region of the domain
  Index fixed = 0;             // vertices of the 1D mesh come first

  Index vertex_count() const { return static_cast<Index>(points.size()); }
  Index triangle_count() const { return static_cast<Index>(triangles.size()); }
  Index origin(Index e) const { return corners_of(triangles)[e]; }
  Index target(Index e) const { return origin(next_in_triangle(e)); }
  Index apex(Index e) const { return origin(prev_in_triangle(e)); }
};

/// One half-edge leaving each vertex (a wall half-edge where the vertex has one), none if unused.
std::vector<Index> outgoing_half_edges(const TriMesh& mesh);  // #V

}  // namespace lpq

// Quad meshes (with triangles where they were allowed) as flat arrays.
#pragma once

#include <array>
#include <vector>

#include "base/index.h"
#include "geometry/vec.h"

namespace lpq {

using Face = std::array<Index, 4>;  // counter-clockwise; slot 3 is none for a triangle

inline int corner_count(const Face& face) { return face[3] == none ? 3 : 4; }

/// The mean of the corners.
inline Vec2 centre_of(const std::vector<Vec2>& points, const Face& face) {
  const int n = corner_count(face);
  Vec2 sum;
  for (int k = 0; k < n; ++k) sum += points[face[k]];
  return (1.0 / n) * sum;
}

struct QuadMesh {
  std::vector<Vec2> points;   // #V  unit-frame coordinates; 0 .. fixed-1 never move
  std::vector<Face> faces;    // #F
  std::vector<Index> region;  // #F  region of the domain
  Index fixed = 0;            // vertices of the 1D mesh come first
  // Walls inside the domain (constraint edges, region borders): no operation may merge or flip
  // across them. Outer boundary edges need no entry: they have one face only.
  std::vector<std::array<Index, 2>> walls;  // #W  a < b, sorted
  // In a part of a larger mesh: quads at each fixed vertex that lie outside the part. Four in all
  // are wanted there; none: the angle at the vertex decides. Empty: it does so everywhere.
  std::vector<Index> outside;  // #fixed
};

}  // namespace lpq

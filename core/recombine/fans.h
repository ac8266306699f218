// The corners around every vertex, grouped into fans: a vertex inside has one closed fan, a vertex
// on a wall one open fan per stretch between two walls. How many quads a fan should hold is what
// the matching is steered by at the boundary.
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace lpq {

struct Fan {
  Index first = none;  // its clockwise-most half-edge leaving the vertex: a wall when open
  Index last = none;   // its counter-clockwise-most half-edge leaving the vertex
  Index triangles = 0;
  Index ideal = 4;  // number of quads that fits the angle
  bool closed = false;
};

struct Fans {
  std::vector<Fan> list;         // #fans, in order of their first half-edge
  std::vector<Index> of_corner;  // 3 #T  fan of the corner at each half-edge's origin
};

Fans find_fans(const TriMesh& mesh);

}  // namespace lpq

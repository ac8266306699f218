// The sides of faces, filed under the edges they lie on.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"

namespace lpq {

/// From corner k of a face to the next.
struct FaceSide {
  std::array<Index, 2> ends{none, none};  // of its edge, the smaller vertex first
  bool forward = true;                    // runs from the smaller to the larger
  Index face = none;
  int corner = 0;
};

/// Of all faces: by edge, then by face and corner. Cost O(#F log #F).
std::vector<FaceSide> sides_by_edge(std::span<const Face> faces);

/// Calls visit(std::span<const FaceSide>) for every edge, ascending, with the sides on it.
template <class Visit>
void for_each_edge(std::span<const FaceSide> sides, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j].ends == sides[i].ends) ++j;
    visit(sides.subspan(i, j - i));
  }
}

/// The corner, as 4 face + k, of a side's face at one of its ends.
inline Index corner_at(std::span<const Face> faces, const FaceSide& side, Index vertex) {
  const Face& face = faces[side.face];
  const int next = (side.corner + 1) % corner_count(face);
  return 4 * side.face + (face[side.corner] == vertex ? side.corner : next);
}

}  // namespace lpq

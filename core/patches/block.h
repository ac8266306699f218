// Polygons with three to five corners filled with a regular grid, or with as many grids as corners
// around one irregular vertex. A polygon is its sides: vertices in counter-clockwise order from one
// corner to the next, both included. Everything about whether a filling exists depends on the
// numbers of edges alone:
//
//   n = 4   opposite sides equal: one grid, no irregular vertex;
//   n = 3   spoke j, from the centre to side j + 1, has r_j = S/2 - s_j edges (S the sum);
//   n = 5   r_j = (s_j + s_{j+1} + s_{j+4} - s_{j+2} - s_{j+3}) / 2;
//
// all r_j must be whole and positive. Compare the pattern parameters of [Takayama et al. 2014] and
// the patches of [Bunin 2006].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"

namespace lpq {

inline constexpr int most_block_corners = 5;

/// Edges of the spokes of an n-gon; `fits` is false where no filling exists.
struct Spokes {
  bool fits = false;
  int least = 0;  // shortest spoke to the outline; of a grid: its shorter side
  std::array<int, most_block_corners> edges{};
};

enum class LastSide {
  outline,  // like the others
  cut,      // another block lies beyond: the irregular vertex may lie on it (a spoke of no edges)
};

/// `lengths`: edges of each side, 3 to 5 sides. A 4-gon has no spokes.
Spokes find_spokes(std::span<const int> lengths, LastSide last = LastSide::outline);

/// Vertices 0 .. given-1 are the outline's; new ones follow.
struct Filling {
  std::vector<Vec2> points;
  std::vector<Face> faces;
};

using VertexRow = std::vector<Index>;

/// Fills the polygon (find_spokes must fit). New vertices lie where transfinite interpolation
/// (Coons) of the sides puts them; the faces may overlap where the polygon is far from convex.
void fill_block(std::span<const VertexRow> sides, Filling& filling);

/// `edges` equal steps from a to b, ends included.
VertexRow straight_side(Index a, Index b, int edges, Filling& filling);

}  // namespace lpq

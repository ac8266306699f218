// Borders laid on a lattice, and the quads between them.
#pragma once

#include <optional>
#include <vector>

#include "geometry/vec.h"
#include "mesh/quad_mesh.h"

namespace lpq {

struct LatticePlace {
  Index x = 0, y = 0;

  LatticePlace operator+(LatticePlace other) const { return {x + other.x, y + other.y}; }
  LatticePlace operator-(LatticePlace other) const { return {x - other.x, y - other.y}; }
  bool operator==(const LatticePlace&) const = default;
};

/// One step right, up, left or down for 0 to 3; and so on, every four.
LatticePlace lattice_step(Index direction);

/// A closed line on the lattice, one step from place to place, the domain on its left.
struct LatticeLoop {
  std::vector<Index> nodes;
  std::vector<LatticePlace> places;
};

/// Loops on one lattice, the outer one first. Where it goes `round`, places whose y differs by that
/// many rows are one, and y grows to the left round `centre`; else `round` is 0.
struct LaidLoops {
  std::vector<LatticeLoop> loops;
  Index round = 0;
  Vec2 centre;
};

/// Cells of the lattice: their corners are the nodes of the loops and `inside` more vertices.
struct LatticeQuads {
  std::vector<Face> faces;
  Index inside = 0;
};

/// The cells that the loops enclose; the loops' vertices are their nodes, 0 to `node_count` - 1.
/// None if two nodes share a place, if some cell is neither inside once nor outside, or if the
/// loops span more than `most` places. Cost O(places spanned).
std::optional<LatticeQuads> lattice_quads(const LaidLoops& laid, Index node_count, double most);

}  // namespace lpq

// A surface with fewer triangles, for what need not see every one of them.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace lpq {

struct CoarseSurface {
  SurfaceMesh mesh;
  std::vector<char> feature;    // #half-edges of `mesh`
  std::vector<Index> vertex;    // #V of `mesh`  of the surface given: nothing moves
  std::vector<Index> triangle;  // #T of `mesh`  one of the surface given: same face and group
  std::vector<Index> home;      // #V of the surface given: the vertex of `mesh` that it went into
};

/// Vertices inside faces go into neighbours, in passes over all of them and never two neighbours in
/// one, where triangles stay well shaped, turn little, pass the vertex nearby, and have no new side
/// longer than `longest` (#V). All vertices on features (`feature` marks half-edges, both sides)
/// and walls stay, and all their edges. Cost O(#T) for each halving.
CoarseSurface coarsen(const SurfaceMesh& mesh, std::span<const char> feature,
                      std::span<const double> longest);

}  // namespace lpq

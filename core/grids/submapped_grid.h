// The plain patterns of a face whose border can be laid on a lattice: grids from side to side, or
// round a hole, with holes where the face has them.
#pragma once

#include <optional>

#include "domain/boundary.h"
#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Submapping [WWBB96], in the unit frame: every loop of the border runs along the lines of a
/// lattice (laid_in_plane), and the cells between the loops are the quads: no vertex inside is
/// irregular. Each lies between its neighbours, or where its quads are convex. Up to 2 % of the
/// quads may not be, for want of nodes opposite each other on the border. None where a loop does
/// not close on the lattice, loops touch there, something divides the inside or more quads are not
/// convex; and none where far more or fewer quads are `wanted` (the integral of 1/h^2).
/// `triangles`: of the domain, the nodes first; only holes need them. Cost that of sparse systems
/// of #triangles and #quads.
std::optional<QuadMesh> submapped_grid(const BoundaryMesh& boundary, const TriMesh& triangles,
                                       double wanted);

/// The same on a lattice that goes round the largest hole (laid_round).
std::optional<QuadMesh> ring_grid(const BoundaryMesh& boundary, const TriMesh& triangles,
                                  double wanted);

/// Is one of the face's corners a node of the border?
bool touches_border(const QuadMesh& grid, const Face& face);

}  // namespace lpq

// The borders of a face on a lattice: as it lies in the plane, or round a hole.
#pragma once

#include <optional>

#include "domain/boundary.h"
#include "grids/lattice.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// The outer border turns once in all, holes once the other way (loop_turns.h), and lie where a
/// harmonic map has them (hole_places.h). None where one does not close on the lattice, or if
/// something divides the inside. `triangles`: of the domain, the nodes first; only holes need them.
/// Cost that of sparse systems of #triangles.
std::optional<LaidLoops> laid_in_plane(const BoundaryMesh& boundary, const TriMesh& triangles);

/// Of a ring: the lattice runs round the largest hole, as circles and rays do, which a logarithm
/// makes straight lines. Its border and the outer one need as many rows, and are as far apart as
/// the number of quads `wanted` asks for; other holes are as above. None also where there is no
/// hole, or where it does not lie round its centre.
std::optional<LaidLoops> laid_round(const BoundaryMesh& boundary, const TriMesh& triangles,
                                    double wanted);

}  // namespace lpq

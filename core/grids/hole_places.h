// Where the holes of a face lie on the lattice of its outer border.
#pragma once

#include <vector>

#include "grids/lattice.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Shifts all loops but the first `count`, which stay, to places near those that a harmonic map of
/// the triangles gives them. Those nearest to a place of the lattice go there first, and the map of
/// the others is made anew, as in mixed-integer parametrisation [BZK09]. The loops' nodes must be
/// the fixed vertices of `triangles`. False if there is no such map. Cost that of a few sparse
/// systems of #triangles.
bool place_holes(const TriMesh& triangles, std::size_t count, LaidLoops& laid);

}  // namespace lpq

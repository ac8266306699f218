// The cross field of the paper's section 4: Laplace's equation for z = e^{4 i theta}, whose fourth
// power makes the four arms of a cross one value.
#pragma once

#include <span>
#include <vector>

#include "field/field.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// z at the vertices, unit length, zero only where undefined. Dirichlet values stand on wall edges
/// (Crouzeix-Raviart unknowns at edge midpoints), so a corner never averages two directions before
/// the solve. Cost: one sparse Cholesky factorisation with #E unknowns.
std::vector<Vec2> solve_cross_field(const TriMesh& mesh);

/// Triangles round which z turns, with neighbouring opposite pairs cancelled, in triangle order.
std::vector<Singularity> find_singularities(const TriMesh& mesh, std::span<const Vec2> z);

}  // namespace lpq

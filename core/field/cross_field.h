// The cross field of the paper's section 4: Laplace's equation for z = e^{4 i theta}, whose fourth
// power makes the four arms of a cross one value.
#pragma once

#include <span>
#include <vector>

#include "field/field.h"
#include "field/guides.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct CrossField {
  std::vector<Vec2> z;     // #V  unit length, zero only where undefined
  std::vector<Vec2> pull;  // #V  z at guides, 0 elsewhere; empty without guides
};

/// Dirichlet values stand on wall edges
/// (Crouzeix-Raviart unknowns at edge midpoints), so a corner never averages two directions before
/// the solve. Edges inside that chords of guides meet have the chords' cross as a Dirichlet value
/// too, unless those contradict each other. Cost: one sparse Cholesky factorisation with #E
/// unknowns.
CrossField solve_cross_field(const TriMesh& mesh, std::span<const Chord> guides = {});

/// Triangles round which z turns, with neighbouring opposite pairs cancelled, in triangle order.
std::vector<Singularity> find_singularities(const TriMesh& mesh, std::span<const Vec2> z);

}  // namespace lpq

// L-BFGS over the free vertices of a mesh, preconditioned by their own sizes: the unknown of vertex
// v is its displacement divided by s_v, so that a mesh graded over four orders of magnitude is as
// well scaled as a uniform one. Vertices with s_v = 0 stay.
#pragma once

#include "base/function_ref.h"
#include "cleanup/shape_energy.h"

namespace lpq {

/// Energy of all vertex positions; adds to `gradient` (#V, zeroed by the caller).
using VertexEnergy =
    FunctionRef<Evaluation(std::span<const Vec2> points, std::span<Vec2> gradient)>;

/// Harmonic mean (of the squares) of the edge lengths at each free vertex (index v - fixed): the
/// second derivatives of any shape measure go like 1 / length^2, so the short edges rule. 0: no
/// edge.
std::vector<double> vertex_sizes(const QuadMesh& mesh);
/// 1 / mean squared edge length of each face: the unit that makes its own corners about 1.
std::vector<double> own_inverse_squares(std::span<const Face> faces, std::span<const Vec2> points);

/// Moves mesh.points[fixed..] downhill for at most `iterations` steps of at most 0.2 s_v each.
/// Returns the steps made: fewer when the energy no longer drops.
int descend(QuadMesh& mesh, std::span<const double> sizes, int iterations, VertexEnergy energy);

}  // namespace lpq

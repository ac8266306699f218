// Integer points of two phases whose gradients follow the crosses: periodic global parametrisation
// [Ray et al. 2006] on the background mesh, one linear solve.
#pragma once

#include <vector>

#include "domain/boundary.h"
#include "field/field.h"

namespace lpq {

struct PhasePoint {
  Vec2 position;
  Index triangle = none;  // background triangle that holds it
};

/// At each vertex U = e^{2 pi i u}, V = e^{2 pi i v} with grad u, grad v ~ the cross / h (after the
/// stretch), and U = V = 1 at every node of the boundary, so that level lines pass through the
/// nodes. Returns the points where u and v are both integers, triangle by triangle; points on
/// shared edges may come twice, and none come from triangles where the phases do not close. Empty
/// when there are too many unknowns for a direct solve. Cost: one sparse Cholesky factorisation
/// with four unknowns per free vertex.
std::vector<PhasePoint> phase_points(const BoundaryMesh& boundary, const Fields& fields);

}  // namespace lpq

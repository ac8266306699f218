// What it costs to merge two triangles into a quad.
#pragma once

#include <cstdint>

#include "field/field.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Mean over the quad's sides of (1 - cos 4 (angle - theta)) / 2: 0 when all follow the cross z,
/// 1 when all are at 45 degrees to it.
double misalignment(const Vec2 (&quad)[4], Vec2 z);

/// round(10^4 (1 - eta + w misalignment)) of the quad across half-edge e, more if eta = 0. The
/// cross is sampled at the quad's centre, eta and sides are those after the stretch there; `fields`
/// without a background counts no misalignment.
std::int64_t pair_cost(const TriMesh& mesh, Index e, const Fields& fields, double alignment_weight,
                       Index& hint);

}  // namespace lpq

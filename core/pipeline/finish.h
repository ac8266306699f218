// From the internal quad mesh to what the caller gets, and the check that it is what was promised.
#pragma once

#include <vector>

#include "domain/boundary.h"
#include "domain/domain.h"
#include "field/field.h"
#include "mesh/output_mesh.h"
#include "mesh/quad_mesh.h"
#include "mesh/validate.h"
#include "pipeline/report.h"

namespace lpq {

/// Caller's units, caller's numbering: nodes of the 1D mesh first, in the order they were given,
/// with the given bits. Drops unused free vertices.
OutputMesh to_output(const QuadMesh& mesh, const Domain& domain, const BoundaryMesh& boundary);

/// The promise, checked on the very coordinates that leave the library. Empty = kept.
std::vector<Violation> check_output(const OutputMesh& mesh);

/// What the caller is told of them: touching, if points of the boundary all but coincide there.
Error no_valid_mesh(const OutputMesh& mesh, const std::vector<Violation>& violations);

/// Tells of every triangle where it is and how good; for meshes that have one only in parts of odd
/// count.
std::vector<Warning> tell_triangles(const OutputMesh& mesh);

/// Of quads that are convex by rounding or little more, or triangles but for a side next to
/// nothing: how many, and where the first is.
std::vector<Warning> tell_poor_quads(const OutputMesh& mesh);

/// Achieved edge length over the target at the edge's midpoint.
SizeFidelity size_fidelity(const QuadMesh& mesh, const Fields& fields);

/// Fingerprint of points and faces.
std::uint64_t output_hash(const OutputMesh& mesh);

}  // namespace lpq

// The refined 1D mesh: every given vertex stays, long edges are divided by a graded spacing.
#pragma once

#include "domain/boundary.h"

namespace lpq {

/// Errors: bad_size, too_many_elements (before anything large is allocated).
Result<BoundaryMesh> refine_boundary(const Domain& domain, const BoundaryOptions& options);

}  // namespace lpq

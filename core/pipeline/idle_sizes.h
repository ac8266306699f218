// Sizes at points that ask for nothing because they lie outside the domain: as likely as not in
// another unit of length, or in coordinates of another file.
#pragma once

#include "domain/boundary.h"
#include "field/make_fields.h"
#include "geometry/frame.h"
#include "pipeline/options.h"

namespace lpq {

/// A size outside the domain grows on its way in, as a field of distances would. One warning, with
/// count and first place, of those that have grown beyond the size that is asked for anyway where
/// they arrive; none where a function of sizes wins over them. `options` are those that made
/// `fields`.
std::vector<Warning> idle_sizes(const UserFields& user, const UnitFrame& frame,
                                const BoundaryMesh& boundary, const FieldOptions& options,
                                const Fields& fields);

}  // namespace lpq

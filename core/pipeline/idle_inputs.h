// Sizes, guides and start points that do nothing because they lie outside the domain: as likely as
// not they are in another unit of length, or in coordinates of another file. One warning for each
// kind, with count and first place.
#pragma once

#include "domain/boundary.h"
#include "field/make_fields.h"
#include "geometry/frame.h"
#include "pipeline/options.h"

namespace lpq {

/// A size outside the domain grows on its way in, as a field of distances would. Those are idle
/// that have grown beyond the size that is asked for anyway where they arrive; none where a
/// function of sizes wins over them. `options` are those that made `fields`.
std::vector<Warning> idle_sizes(const UserFields& user, const UnitFrame& frame,
                                const BoundaryMesh& boundary, const FieldOptions& options,
                                const Fields& fields);

/// Guides that no part of the domain follows; none where a function of directions wins over them.
std::vector<Warning> idle_guides(const UserFields& user, const FieldOptions& options,
                                 const Fields& fields);

/// Is there nothing of the caller's that decides on sizes or directions?
bool fields_are_ours(const UserFields& user, const UnitFrame& frame, const BoundaryMesh& boundary,
                     const FieldOptions& options, const Fields& fields);

/// Start points outside, which are left out.
std::vector<Warning> idle_seeds(const UserFields& user, const UnitFrame& frame,
                                const Fields& fields);

}  // namespace lpq

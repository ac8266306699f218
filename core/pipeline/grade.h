// The boundary mesh and what the sizes inside are to be, for a size or for a number of quads.
#pragma once

#include "domain/boundary.h"
#include "domain/domain.h"
#include "field/make_fields.h"
#include "pipeline/options.h"

namespace lpq {

/// A boundary with the sizes inside still to come.
struct Graded {
  BoundaryMesh boundary;
  FieldOptions fields;
};

/// For this size in the unit frame; 0: that of the kept boundary's spacing. How fast sizes grow is
/// what the options say, or what is affordable. Errors: those of sample_boundary, estimate_quads.
Result<Graded> grade_for_size(const Domain& domain, const Options& options, const UserFields& user,
                              double size);

/// For Options::quads, by a search that begins at this size. Where sizes of gentle slope would ask
/// for more by themselves, they grow faster. Errors: as above. Cost: up to 25 times that of the
/// above.
Result<Graded> grade_for_count(const Domain& domain, const Options& options, const UserFields& user,
                               double first);

}  // namespace lpq

// Sizes, guides and start points that do nothing because they lie outside the domain: as likely as
// not they are in another unit of length, or in coordinates of another file. One warning for each
// kind, with count and first place.
#pragma once

#include "domain/boundary.h"
#include "field/make_fields.h"
#include "geometry/frame.h"
#include "pipeline/options.h"

namespace lpq {

struct IdleInputs {
  std::vector<Warning> warnings;  // at most one for sizes, guides, start points each
  bool decide_on_fields = false;  // are there others, or functions, that do something?
};

/// A size outside the domain grows on its way in, as a field of distances would: those are idle
/// that have grown beyond the size that is asked for anyway where they arrive. Guides are that no
/// part of the domain follows, start points that are outside. What a function stands in for is not
/// looked at. `options` are those that made `fields`.
IdleInputs idle_inputs(const UserFields& user, const UnitFrame& frame, const BoundaryMesh& boundary,
                       const FieldOptions& options, const Fields& fields);

}  // namespace lpq

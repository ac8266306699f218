// The caller's fields, judged where the caller gave them and moved into the unit frame, in which
// what is far from the domain or of another scale may be beyond what doubles hold.
#pragma once

#include <vector>

#include "base/result.h"
#include "domain/boundary.h"
#include "domain/domain.h"
#include "geometry/frame.h"
#include "pipeline/options.h"

namespace lpq {

/// Errors, with places as given: bad_size for a size at a point that is not positive; non_finite
/// for its place or a point of a guide; bad_option for a guide that goes too far from the domain
/// and for a detail that is no length; too_many_elements for one that asks for a larger background
/// than a run of at most `max_elements` is to have.
Problem judge_user_fields(const UserFields& user, const Domain& domain, double max_elements);

/// Of sizes or directions.
bool has_function(const UserFields& user);

/// Whether distances from the domain can be computed.
bool is_within_reach(Vec2 point, const UnitFrame& frame);

/// A size where it is a positive number; anything else as it is.
double size_in_frame(double size, const UnitFrame& frame);

/// The sizes at points, which are judged already, without those out of reach: they ask nothing of
/// the domain.
std::vector<SizeSample> samples_in_frame(const UserFields& user, const UnitFrame& frame);

}  // namespace lpq

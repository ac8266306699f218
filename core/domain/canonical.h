// From a judged outline to the Domain's canonical arrays.
#pragma once

#include "domain/judge.h"

namespace lpq {

/// Outer loops counter-clockwise, holes clockwise, each from its lexicographically smallest point;
/// the loops of a region ordered by that point, the regions as given. Edges shared by two regions
/// become one segment. Errors: region_conflict (two regions on the same side of an edge).
Result<Domain> make_canonical(const Outline& outline, const LoopRoles& roles);

}  // namespace lpq

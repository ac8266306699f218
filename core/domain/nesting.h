// Which loop of a region lies inside which other.
#pragma once

#include "domain/judge.h"
#include "domain/meetings.h"

namespace lpq {

/// Errors: hole_outside before nested_or_duplicate_hole. Requires that no edges cross. One ray per
/// hole, which loops beside the hole do not slow down.
Problem judge_nesting(const Outline& outline, const LoopRoles& roles, const Meetings& meetings);

}  // namespace lpq

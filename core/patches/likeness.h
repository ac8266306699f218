// Whether a filling is what its patch holds already.
#pragma once

#include "patches/block.h"
#include "patches/growth.h"

namespace lpq {

/// The faces of `filling` are those of the patch, but for the numbers of the vertices inside. Only
/// fillings of as many faces as the patch has can be. Cost O(F log F).
bool is_like_patch(const Filling& filling, const PatchOutline& outline, const QuadTopology& mesh);

}  // namespace lpq

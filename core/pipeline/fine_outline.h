// Outlines drawn far finer than the mesh that is asked for: every point is a vertex of it, and
// quads beside close points are as small as they lie.
#pragma once

#include <vector>

#include "domain/domain.h"

namespace lpq {

/// A warning with a tolerance for Options::simplify, where `quads` are many more than quads of
/// `size` (unit frame) would be, and most points of the outline could be left out. Cost: of
/// simplify_boundary, and only where there are so many.
std::vector<Warning> tell_fine_outline(const Domain& domain, double size, double quads);

}  // namespace lpq

// Small changes of the connectivity around one quad of a patch, for when no position of the
// vertices makes it good: a diagonal collapsed, an edge turned, a vertex opened, a straight corner
// on a feature shared with a second quad, a ring of quads put inside the quad. Edges on features
// stay, and so do vertices on them and on the rim of the patch.
#pragma once

#include <vector>

#include "shell/shape/patch.h"

namespace lpq {

/// Every possible change around face f (a quad) of the patch, doublets removed; a closed patch
/// keeps its Euler number. Vertices are not placed well: the caller moves them, and judges.
std::vector<ShapePatch> refills(const ShapeGround& ground, const ShapePatch& patch, Index f);

}  // namespace lpq

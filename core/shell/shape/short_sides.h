// Quads that are triangles but for a tiny side: their angles can be good.
#pragma once

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

/// Is a side less than `share` of the longest one of the face?
bool has_short_side(const ShellMesh& mesh, Index f, double share);

/// Where a quad has a side of less than a twentieth of its longest, it and those around it go where
/// their mean ratios are best, which see sides as well as angles. Only where the surface bends
/// little and no quad is tangled, if all such sides there grow to that length, and no quad gets
/// poor or worse than the worst one was: in a strip that is narrow for the size they cannot.
/// Returns in how many places. Cost O(1) for each such quad, beside O(#F).
Index lengthen_sides(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
                     std::vector<VertexRole>& roles);

}  // namespace lpq

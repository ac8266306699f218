// The safest place for one vertex. For fixed neighbours, "corner is a left turn" is a linear
// condition on v for each of the three corners of a face that v takes part in: v lies left of a
// line. The kernel of the star is the intersection of these half-planes, and its Chebyshev centre,
// the point that is farthest from the nearest line, makes all faces of the star strictly convex
// whenever any position does. A linear programme in three unknowns.
#pragma once

#include <span>

#include "mesh/quad_mesh.h"

namespace lpq {

struct StarCentre {
  Vec2 position;
  double before = 0, after = 0;  // least signed distance to a line, in units of `size`
};

/// `faces` are those around v. The search stays within 2 `size` of v. Cost O(k) for k faces, times
/// the exchanges of the simplex method, 64 at most.
StarCentre star_centre(std::span<const Vec2> points, std::span<const Face> all,
                       std::span<const Index> faces, Index v, double size);

}  // namespace lpq

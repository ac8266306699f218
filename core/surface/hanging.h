// Hanging points: where one sheet has a point on an edge of another (a T-junction), the two have
// the same border and do not share it. Triangulations made face by face are full of them.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Closes borders like a zip, from the points where two of them begin together: while the nearer of
/// the next two points lies within `reach` of the other's edge, the triangle of that edge is
/// divided there. No point moves; edges shorter than ten times the reach stay as they are. Rows of
/// `triangles` and `group` change. Returns how many points hung. Cost O(#T log #T).
Index share_hanging_points(std::span<const Vec3> points, double reach, std::vector<Tri>& triangles,
                           std::vector<Index>& group);

}  // namespace lpq

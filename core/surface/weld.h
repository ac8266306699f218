// Points that are one point: equal, or nearer to each other than a distance.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// For each point the first point that it is welded to (itself if none is before it). Points within
/// `distance` are one, and so are chains of such points; 0 welds equal points only, where
/// coordinates below 1e-60 are 0 (so that different points have a distance); else it must be 1e-15
/// of the extent or more, so that the points' cells can be counted. Points that are not `used` stay
/// alone and may be anything; the others must be finite. `body`: #V, or empty for one; points of
/// different bodies are never one. Cost O(#V log #V).
std::vector<Index> weld_points(std::span<const Vec3> points, std::span<const char> used,
                               double distance, std::span<const Index> body = {});

struct OpenEdges {
  Index count = 0;      // edges of one triangle
  Index collapsed = 0;  // triangles with a corner twice, which have no edges
};

/// Of the triangles, if every point is the one that `first` says. Cost O(#T log valence).
OpenEdges open_edges(std::vector<Tri> triangles, std::span<const Index> first);

}  // namespace lpq

// From the triangulated plane to the mesh of the domain: a flood from both sides of every segment
// spreads the segment's region up to the next walls; triangles of no region are dropped. Every
// part of the plane between walls touches a wall, so the flood reaches all of them. Cost O(n).
#include <utility>

#include "delaunay/whole_plane.h"

namespace lpq {
namespace {

constexpr Index unvisited = none - 1;

void flood(const WholePlane& plane, Index start, Index label, std::vector<Index>& region,
           std::vector<Index>& stack) {
  if (region[start] != unvisited) return;
  region[start] = label;
  stack.assign({start});
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      const Index other = triangle_of(plane.twins[e]);
      if (plane.wall[e] || region[other] != unvisited) continue;
      region[other] = label;
      stack.push_back(other);
    }
  }
}

// Keeps the triangles with a region >= 0, in place, with twins cut at walls and at the rim.
TriMesh extract(WholePlane&& plane, std::vector<Index>&& region) {
  std::vector<Index> number(region.size(), none);
  Index count = 0;
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (region[t] >= 0) number[t] = count++;
  }
  Index* corners = corners_of(plane.triangles);
  for (Index t = 0; t < plane.triangle_count(); ++t) {
    if (number[t] == none) continue;
    for (Index k = 0; k < 3; ++k) {
      const Index e = 3 * t + k, kept = 3 * number[t] + k, f = plane.twins[e];
      const Index beyond = number[triangle_of(f)];
      const bool cut = beyond == none || (!plane.wall.empty() && plane.wall[e]);
      corners[kept] = plane.given[corners[e]];
      plane.twins[kept] = cut ? none : 3 * beyond + (f - 3 * triangle_of(f));
    }
    region[number[t]] = region[t];
  }
  plane.triangles.resize(count);
  plane.twins.resize(3 * static_cast<std::size_t>(count));
  region.resize(count);
  TriMesh mesh;
  mesh.triangles = std::move(plane.triangles);
  mesh.twins = std::move(plane.twins);
  mesh.region = std::move(region);
  return mesh;
}

}  // namespace

TriMesh carve(WholePlane&& plane, std::span<const Segment> segments) {
  const std::vector<Index> vertex = vertex_numbers(plane);
  const std::vector<Index> leaving = leaving_half_edges(plane);
  std::vector<Index> region(plane.triangle_count(), unvisited), stack;
  for (const Segment& s : segments) {
    const Index e = find_edge(plane, leaving, vertex[s.a], vertex[s.b]);
    LPQ_ASSERT(e != none);
    flood(plane, triangle_of(e), s.left, region, stack);
    flood(plane, triangle_of(plane.twins[e]), s.right, region, stack);
  }
  return extract(std::move(plane), std::move(region));
}

TriMesh without_ghosts(WholePlane&& plane) {
  std::vector<Index> region(plane.triangle_count());
  for (Index t = 0; t < plane.triangle_count(); ++t) region[t] = plane.is_ghost(t) ? none : 0;
  return extract(std::move(plane), std::move(region));
}

}  // namespace lpq

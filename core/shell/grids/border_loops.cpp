// See border_loops.h.
#include "shell/grids/border_loops.h"

#include <utility>

#include "geometry/polygon.h"

namespace lpq {

std::vector<Vec2> points_of(const BoundaryMesh& boundary, const std::vector<Index>& loop) {
  std::vector<Vec2> points;
  points.reserve(loop.size());
  for (const Index v : loop) points.push_back(boundary.points[v]);
  return points;
}

std::vector<std::vector<Index>> border_loops(const BoundaryMesh& boundary) {
  std::vector<Index> next(boundary.points.size(), none);
  for (const Segment& edge : boundary.edges) {
    const bool inside = edge.left != none && edge.right != none;
    const Index from = edge.left != none ? edge.a : edge.b;
    if (inside || next[from] != none) return {};
    next[from] = edge.left != none ? edge.b : edge.a;
  }
  std::vector<std::vector<Index>> loops;
  std::vector<char> done(next.size(), 0);
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (done[first]) continue;
    loops.emplace_back();
    for (auto v = static_cast<Index>(first); !done[v]; v = next[v]) {
      if (next[v] == none) return {};
      done[v] = 1;
      loops.back().push_back(v);
    }
    if (signed_area(points_of(boundary, loops.back())) > 0) std::swap(loops.front(), loops.back());
  }
  return loops;
}

}  // namespace lpq

// See border_loops.h.
#include "grids/border_loops.h"

#include <cmath>
#include <utility>

#include "geometry/polygon.h"
#include "numerics/elementary.h"

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
  bool has_outline = false;
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (done[first]) continue;
    loops.emplace_back();
    for (auto v = static_cast<Index>(first); !done[v]; v = next[v]) {
      if (next[v] == none) return {};
      done[v] = 1;
      loops.back().push_back(v);
    }
    if (!(signed_area(points_of(boundary, loops.back())) > 0)) continue;
    if (has_outline) return {};
    has_outline = true;
    std::swap(loops.front(), loops.back());
  }
  return loops;
}

std::size_t largest_hole(const BoundaryMesh& boundary,
                         const std::vector<std::vector<Index>>& loops) {
  std::size_t largest = 1;
  double most = 0;
  for (std::size_t k = 1; k < loops.size(); ++k) {
    const double area = std::fabs(signed_area(points_of(boundary, loops[k])));
    if (!(area > most)) continue;
    most = area;
    largest = k;
  }
  return largest;
}

Vec2 centre_of(const std::vector<Vec2>& polygon) {
  Vec2 sum;
  double area = 0;
  const Vec2 origin = polygon[0];
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec2 a = polygon[k] - origin, b = polygon[k + 1] - origin;
    sum += cross(a, b) * (a + b);
    area += cross(a, b);
  }
  return origin + (1 / (3 * area)) * sum;
}

double axis_of(const BoundaryMesh& boundary) {
  const auto square = [](Vec2 z) { return complex_product(z, z); };
  Vec2 sum;
  for (const Segment& edge : boundary.edges) {
    const Vec2 d = boundary.points[edge.b] - boundary.points[edge.a];
    const double size = length(d);
    sum += (1 / (size * size * size)) * square(square(d));
  }
  return arc_tangent(sum.y, sum.x) / 4;
}

}  // namespace lpq

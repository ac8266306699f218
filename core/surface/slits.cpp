#include "surface/slits.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "surface/edges.h"
#include "surface/weld.h"

namespace lpq {
namespace {

constexpr double long_edge = 100;  // times the reach
constexpr double longer_than_gap = 20;

}  // namespace

std::vector<Index> points_across_slits(std::span<const Vec3> points, std::span<const Tri> triangles,
                                       double reach) {
  const auto count = static_cast<Index>(points.size());
  const SurfaceEdges edges = surface_edges(triangles, count);
  DisjointSets lines(count);
  std::vector<char> used(points.size(), 0);
  for (Index e = 0; e < edges.count(); ++e) {
    if (edges.half_edges.row(e).size() != 1) continue;
    const auto [a, b] = edges.ends[e];
    lines.unite(a, b);
    if (distance(points[a], points[b]) > long_edge * reach) used[a] = used[b] = 1;
  }
  if (std::find(used.begin(), used.end(), 1) == used.end()) return {};
  std::vector<Index> line(points.size());
  for (Index v = 0; v < count; ++v) line[v] = lines.root(v);
  std::vector<Index> first = weld_points(points, used, reach, line);
  for (Index v = 0; v < count; ++v)
    if (first[v] != v) return first;
  return {};
}

BorderGap border_gap(std::span<const Vec3> points, std::span<const Tri> triangles, double reach,
                     std::span<const Index> body) {
  const auto count = static_cast<Index>(points.size());
  const SurfaceEdges edges = surface_edges(triangles, count);
  std::vector<char> used(points.size(), 0), at_short_edge = used;
  for (Index e = 0; e < edges.count(); ++e) {
    if (edges.half_edges.row(e).size() != 1) continue;
    const auto [a, b] = edges.ends[e];
    used[a] = used[b] = 1;
    if (distance(points[a], points[b]) < longer_than_gap * reach)
      at_short_edge[a] = at_short_edge[b] = 1;
  }
  for (Index v = 0; v < count; ++v) used[v] &= !at_short_edge[v];
  const std::vector<Index> first = weld_points(points, used, reach, body);
  BorderGap gap;
  for (Index v = 0; v < count; ++v) {
    if (first[v] == v) continue;
    if (gap.points++ == 0) gap.at = points[v];
    // Of several borders beside each other the first may be far; the next one is not.
    gap.width = std::max(gap.width, std::min(reach, distance(points[v], points[first[v]])));
  }
  return gap;
}

}  // namespace lpq

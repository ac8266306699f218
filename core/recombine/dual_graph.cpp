#include "recombine/dual_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/quality.h"
#include "recombine/costs.h"
#include "recombine/pair_cost.h"

namespace lpq {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

/// Cost per quad of missing the ideal number at a fan.
std::int64_t valence_cost(const Fan& fan, Index quads) {
  const std::int64_t off = quads - fan.ideal;
  if (fan.closed) return inner_valence_cost * (off < 0 ? -off : off);
  return off < 0 ? -off * missing_quad_cost : off * surplus_quad_cost;
}

/// A merge across an edge at the fan's vertex takes one quad away from it. The cost of the number
/// of quads is not linear in the merges, so each merge pays the mean slope between none and all.
std::int64_t merge_slope(const Fan& fan, std::int64_t most) {
  const Index all = fan.triangles / 2;
  if (all == 0) return 0;
  return std::min(
      most, (valence_cost(fan, fan.triangles - all) - valence_cost(fan, fan.triangles)) / all);
}

void add_merges(const TriMesh& mesh, const Fans& fans, const Fields& fields,
                double alignment_weight, std::int64_t steepest, DualGraph& graph) {
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    Index hint = none;
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      if (mesh.twins[e] == none || triangle_of(mesh.twins[e]) <= t) continue;
      const std::int64_t cost =
          pair_cost(mesh, e, fields, alignment_weight, hint) +
          merge_slope(fans.list[fans.of_corner[e]], steepest) +
          merge_slope(fans.list[fans.of_corner[next_in_triangle(e)]], steepest);
      graph.edges.push_back({t, triangle_of(mesh.twins[e]), cost});
      graph.source.push_back(e);
    }
  }
  graph.merges = static_cast<Index>(graph.edges.size());
}

bool are_neighbours(const TriMesh& mesh, Index t, Index s) {
  for (Index e = 3 * t; e < 3 * t + 3; ++e)
    if (mesh.twins[e] != none && triangle_of(mesh.twins[e]) == s) return true;
  return false;
}

/// Splitting the vertex leaves it two quads, which cannot fill a full turn (the end of a wall).
void add_extra_edges(const TriMesh& mesh, const Fans& fans, DualGraph& graph) {
  for (Index f = 0; f < static_cast<Index>(fans.list.size()); ++f) {
    const Fan& fan = fans.list[f];
    const Index t = triangle_of(fan.first), s = triangle_of(fan.last);
    if (fan.closed || fan.triangles < 3 || fan.ideal > 3 || are_neighbours(mesh, t, s)) continue;
    graph.edges.push_back({t, s, extra_edge_cost + valence_cost(fan, 2)});
    graph.source.push_back(f);
  }
}

/// What a triangle costs that is left over, by its own shape.
std::int64_t left_over_cost(const TriMesh& mesh, Index t) {
  const auto [a, b, c] = mesh.triangles[t];
  const double eta = triangle_eta(mesh.points[a], mesh.points[b], mesh.points[c]);
  return static_cast<std::int64_t>(std::floor((1 - eta) * unit_cost + 0.5));
}

/// One node for every part (triangles connected without crossing walls) of odd size, joined to all
/// its triangles: the best place for the left-over triangle is where it and the rest together are
/// cheapest.
void add_partners(const TriMesh& mesh, DualGraph& graph) {
  std::vector<char> seen(mesh.triangles.size(), 0);
  std::vector<Index> part;
  for (Index start = 0; start < mesh.triangle_count(); ++start) {
    if (seen[start]) continue;
    part.assign(1, start);
    seen[start] = 1;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Index e = 3 * part[i]; e < 3 * part[i] + 3; ++e) {
        if (mesh.twins[e] == none || seen[triangle_of(mesh.twins[e])]) continue;
        seen[triangle_of(mesh.twins[e])] = 1;
        part.push_back(triangle_of(mesh.twins[e]));
      }
    if (part.size() % 2 == 0) continue;
    std::sort(part.begin(), part.end());
    for (Index t : part) graph.edges.push_back({t, graph.nodes, left_over_cost(mesh, t)});
    ++graph.nodes;
  }
}

void double_graph(Index triangles, std::int64_t cost, DualGraph& graph) {
  const std::size_t single = graph.edges.size();
  graph.edges.reserve(2 * single + static_cast<std::size_t>(triangles));
  for (std::size_t i = 0; i < single; ++i) {
    const CostEdge edge = graph.edges[i];
    graph.edges.push_back({edge.u + triangles, edge.v + triangles, edge.cost});
  }
  for (Index t = 0; t < triangles; ++t) graph.edges.push_back({t, t + triangles, 2 * cost});
  graph.nodes = 2 * triangles;
}

}  // namespace

DualGraph make_dual_graph(const TriMesh& mesh, const Fans& fans, const Fields& fields,
                          double alignment_weight, Leave leave) {
  DualGraph graph;
  graph.nodes = mesh.triangle_count();
  const bool may_leave = leave == Leave::where_cheaper;
  add_merges(mesh, fans, fields, alignment_weight, may_leave ? most_beside_triangles : no_limit,
             graph);
  switch (leave) {
    case Leave::one_per_odd_part:
      add_extra_edges(mesh, fans, graph);
      add_partners(mesh, graph);
      break;
    case Leave::where_cheaper:  // an extra edge never pays here
      double_graph(mesh.triangle_count(), leave_cost, graph);
      break;
  }
  return graph;
}

}  // namespace lpq

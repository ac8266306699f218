#include "surface/edges.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"

namespace lpq {
namespace {

/// Half-edges in rows of their smaller vertex, in each row by their larger one, then by number.
Csr<Index> half_edges_by_ends(const Index* corners, Index half_edge_count, Index vertex_count) {
  const auto ends = [corners](Index e) {
    const Index a = corners[e], b = corners[next_in_triangle(e)];
    return std::array<Index, 2>{std::min(a, b), std::max(a, b)};
  };
  auto rows = csr_from<Index>(vertex_count, [&](auto&& emit) {
    for (Index e = 0; e < half_edge_count; ++e) emit(ends(e)[0], e);
  });
  for (Index v = 0; v < vertex_count; ++v) {
    sort_numbers(rows.row(v), [&](Index e, Index f) {
      const Index x = ends(e)[1], y = ends(f)[1];
      return x != y ? x < y : e < f;
    });
  }
  return rows;
}

}  // namespace

SurfaceEdges surface_edges(std::span<const Tri> triangles, Index vertex_count) {
  const Index* corners = reinterpret_cast<const Index*>(triangles.data());
  const Index half_edge_count = 3 * static_cast<Index>(triangles.size());
  const Csr<Index> rows = half_edges_by_ends(corners, half_edge_count, vertex_count);
  SurfaceEdges edges;
  edges.edge_of.resize(static_cast<std::size_t>(half_edge_count));
  for (const Index e : rows.values) {
    const Index a = corners[e], b = corners[next_in_triangle(e)];
    const std::array<Index, 2> ends{std::min(a, b), std::max(a, b)};
    if (edges.ends.empty() || edges.ends.back() != ends) {
      if (!edges.ends.empty()) edges.half_edges.end_row();
      edges.ends.push_back(ends);
    }
    edges.edge_of[e] = edges.count() - 1;
    edges.half_edges.values.push_back(e);
  }
  if (!edges.ends.empty()) edges.half_edges.end_row();
  return edges;
}

Csr<Index> edges_at_vertices(const SurfaceEdges& edges, Index vertex_count,
                             std::span<const char> chosen) {
  return csr_from<Index>(vertex_count, [&](auto&& emit) {
    for (Index i = 0; i < edges.count(); ++i) {
      if (!chosen.empty() && !chosen[i]) continue;
      for (const Index v : edges.ends[i]) emit(v, i);
    }
  });
}

std::vector<Index> parts_at_vertices(std::span<const Tri> triangles, const SurfaceEdges& edges,
                                     Index vertex_count) {
  const Index* corners = reinterpret_cast<const Index*>(triangles.data());
  const Index corner_count = 3 * static_cast<Index>(triangles.size());
  const auto corner_at = [corners](Index e, Index vertex) {
    return corners[e] == vertex ? e : next_in_triangle(e);
  };
  DisjointSets sets(corner_count);
  for (Index i = 0; i < edges.count(); ++i) {
    const auto around = edges.half_edges.row(i);
    for (std::size_t k = 1; k < around.size(); ++k)
      for (const Index v : edges.ends[i])
        sets.unite(corner_at(around[0], v), corner_at(around[k], v));
  }
  std::vector<Index> parts(static_cast<std::size_t>(vertex_count), 0);
  for (Index e = 0; e < corner_count; ++e) parts[corners[e]] += sets.root(e) == e;
  return parts;
}

std::vector<char> pinched_vertices(std::span<const Tri> triangles, const SurfaceEdges& edges,
                                   Index vertex_count) {
  const std::vector<Index> parts = parts_at_vertices(triangles, edges, vertex_count);
  std::vector<char> pinched(parts.size());
  for (std::size_t v = 0; v < parts.size(); ++v) pinched[v] = parts[v] > 1;
  return pinched;
}

}  // namespace lpq

// The undirected edges of a surface. Half-edges know one partner at most; an edge where sheets meet
// has any number of them, and only the edge can tell what lies around it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/csr.h"
#include "mesh/surface_mesh.h"

namespace lpq {

struct SurfaceEdges {
  std::vector<std::array<Index, 2>> ends;  // #E  vertices, the smaller first; ascending
  Csr<Index> half_edges;                   // #E  on each edge, ascending
  std::vector<Index> edge_of;              // 3 #T  edge of each half-edge

  Index count() const { return static_cast<Index>(ends.size()); }
  Index other_end(Index edge, Index vertex) const {
    return ends[edge][0] == vertex ? ends[edge][1] : ends[edge][0];
  }
};

/// Two half-edges lie on one edge if they have the same two vertices. Cost O(#T log valence).
SurfaceEdges surface_edges(std::span<const Tri> triangles, Index vertex_count);

/// Edges at every vertex, ascending: of all edges, or of those that are `chosen`.
Csr<Index> edges_at_vertices(const SurfaceEdges& edges, Index vertex_count,
                             std::span<const char> chosen = {});

/// In how many parts the surface comes to each vertex: going around across edges, walls or not,
/// reaches every triangle of a part. #V
std::vector<Index> parts_at_vertices(std::span<const Tri> triangles, const SurfaceEdges& edges,
                                     Index vertex_count);

/// Vertices where more than one part of the surface meets. #V
std::vector<char> pinched_vertices(std::span<const Tri> triangles, const SurfaceEdges& edges,
                                   Index vertex_count);

}  // namespace lpq

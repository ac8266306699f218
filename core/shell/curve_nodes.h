// The nodes of the curves as the edges of the surface see them.
#pragma once

#include "surface/curves.h"
#include "surface/features.h"

namespace lpq {

/// A node on a half-edge, at a share of the way from its origin to its target.
struct NodeOnEdge {
  Index node = none;
  double share = 0;
};

class CurveNodes {
 public:
  CurveNodes(const SurfaceMesh& mesh, const SurfaceEdges& edges, const SurfaceCurves& curves,
             const CurveMesh& nodes);

  /// Calls visit(NodeOnEdge) for the nodes of a feature half-edge in its direction: that at its
  /// origin if there is one, then those on the way; not that at its target.
  template <class Visit>
  void for_each_along(Index e, Visit&& visit) const {
    const Index a = mesh_->origin(e);
    if (const Index corner = nodes_->node_of_corner[a]; corner != none) visit({corner, 0});
    const auto row = on_edge_.row(edges_->edge_of[e]);
    const bool forward = start_[edges_->edge_of[e]] == a;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const NodeOnEdge& at = forward ? row[k] : row[row.size() - 1 - k];
      visit(NodeOnEdge{at.node, forward ? at.share : 1 - at.share});
    }
  }

  /// The node at a vertex of the surface, if it is a corner.
  Index at_vertex(Index v) const { return nodes_->node_of_corner[v]; }

 private:
  const SurfaceMesh* mesh_;
  const SurfaceEdges* edges_;
  const CurveMesh* nodes_;
  std::vector<Index> start_;  // #E  vertex that the curve comes from, none off curves
  Csr<NodeOnEdge> on_edge_;   // #E  along the curve, corners left out
};

}  // namespace lpq

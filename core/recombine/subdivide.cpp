#include "recombine/subdivide.h"

#include <algorithm>

#include "base/sort_numbers.h"

namespace lpq {
namespace {

using Edge = std::array<Index, 2>;

Edge undirected(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

struct NumberedEdge {
  Edge edge;
  Index node;
};

// The boundary's edges by end points, for finding the node in the middle of a wall.
std::vector<NumberedEdge> sorted_edges(const BoundaryMesh& boundary) {
  std::vector<NumberedEdge> edges;
  const Index nodes = static_cast<Index>(boundary.points.size());
  for (Index k = 0; k < static_cast<Index>(boundary.edges.size()); ++k)
    edges.push_back({undirected(boundary.edges[k].a, boundary.edges[k].b), nodes + k});
  sort_values(edges, [](const NumberedEdge& a, const NumberedEdge& b) { return a.edge < b.edge; });
  return edges;
}

Index wall_node(const std::vector<NumberedEdge>& edges, Index a, Index b) {
  const Edge key = undirected(a, b);
  const auto found =
      std::lower_bound(edges.begin(), edges.end(), key,
                       [](const NumberedEdge& e, const Edge& k) { return e.edge < k; });
  LPQ_ASSERT(found != edges.end() && found->edge == key);
  return found->node;
}

}  // namespace

BoundaryMesh halve_edges(const BoundaryMesh& boundary, const UnitFrame& frame) {
  BoundaryMesh fine = boundary;
  fine.edges.clear();
  for (const Segment& s : boundary.edges) {
    const Index middle = static_cast<Index>(fine.points.size());
    const Vec2 world = frame.to_world(midpoint(boundary.points[s.a], boundary.points[s.b]));
    fine.points.push_back(frame.to_frame(world));
    fine.world.push_back(world);
    fine.source.push_back(none);
    fine.spacing.push_back(0.5 * length(boundary.points[s.b] - boundary.points[s.a]));
    fine.output_rank.push_back(middle);
    Segment first = s, second = s;
    first.b = second.a = middle;
    fine.edges.push_back(first);
    fine.edges.push_back(second);
  }
  return fine;
}

QuadMesh subdivide_triangles(const TriMesh& triangles, const BoundaryMesh& boundary,
                             const UnitFrame& frame) {
  const BoundaryMesh fine = halve_edges(boundary, frame);
  QuadMesh quads;
  quads.points = fine.points;
  quads.fixed = static_cast<Index>(fine.points.size());

  // Free vertices of the triangulation come next, then edge midpoints, then centroids.
  std::vector<Index> vertex(triangles.points.size());
  for (Index v = 0; v < triangles.vertex_count(); ++v) {
    vertex[v] = v < triangles.fixed ? v : static_cast<Index>(quads.points.size());
    if (v >= triangles.fixed) quads.points.push_back(triangles.points[v]);
  }
  const std::vector<NumberedEdge> walls = sorted_edges(boundary);
  std::vector<Index> middle(triangles.twins.size(), none);
  for (Index e = 0; e < static_cast<Index>(middle.size()); ++e) {
    const Index twin = triangles.twins[e], a = triangles.origin(e), b = triangles.target(e);
    if (twin == none) {
      middle[e] = wall_node(walls, a, b);
    } else if (twin > e) {
      middle[e] = middle[twin] = static_cast<Index>(quads.points.size());
      quads.points.push_back(midpoint(triangles.points[a], triangles.points[b]));
    }
  }
  for (Index t = 0; t < triangles.triangle_count(); ++t) {
    const Tri& tri = triangles.triangles[t];
    const Index centre = static_cast<Index>(quads.points.size());
    const Vec2 sum = triangles.points[tri[0]] + triangles.points[tri[1]] + triangles.points[tri[2]];
    quads.points.push_back((1.0 / 3) * sum);
    for (Index k = 0; k < 3; ++k) {
      quads.faces.push_back(
          {vertex[tri[k]], middle[3 * t + k], centre, middle[3 * t + (k + 2) % 3]});
      quads.region.push_back(triangles.region[t]);
    }
  }
  for (const Segment& s : fine.edges)
    if (s.left != none && s.right != none) quads.walls.push_back(undirected(s.a, s.b));
  std::sort(quads.walls.begin(), quads.walls.end());
  return quads;
}

}  // namespace lpq

// See chart_domain.h.
#include "shell/chart_domain.h"

#include <algorithm>

#include "base/sort_numbers.h"
#include "base/sort_unique.h"

namespace lpq {
namespace {

class DomainMaker {
 public:
  DomainMaker(const SurfaceMesh& mesh, const Chart& chart, const CurveNodes& nodes)
      : mesh_(mesh), chart_(chart), nodes_(nodes) {}

  ChartDomain run(const SurfaceFeatures& features, const SurfaceCurves& curves,
                  const Atlas& atlas) {
    auto& loops = domain_.input.regions.emplace_back().loops;
    for (Index b = 0; b < chart_.borders.rows(); ++b) {
      Loop loop;
      for (const Index e : chart_.borders.row(b)) append(on_plane(e), loop);
      loops.push_back(std::move(loop));
    }
    add_inner_features(features, curves, atlas);
    add_inner_points(features);
    sort_values(domain_.places, [](const auto& a, const auto& b) {
      return a.position < b.position || (a.position == b.position && a.node < b.node);
    });
    return std::move(domain_);
  }

 private:
  Index on_plane(Index e) const {
    const auto at =
        std::lower_bound(chart_.triangles.begin(), chart_.triangles.end(), triangle_of(e));
    return 3 * static_cast<Index>(at - chart_.triangles.begin()) + e % 3;
  }
  Index on_surface(Index e) const { return 3 * chart_.triangles[triangle_of(e)] + e % 3; }

  /// The nodes along half-edge e of the plane, without that at its target.
  void append(Index e, Loop& loop) {
    const Vec2 a = chart_.plane.points[chart_.plane.origin(e)];
    const Vec2 b = chart_.plane.points[chart_.plane.target(e)];
    nodes_.for_each_along(on_surface(e), [&](NodeOnEdge at) {
      const Vec2 p = at.share == 0 ? a : (1 - at.share) * a + at.share * b;
      loop.push_back(p);
      domain_.places.push_back({p, at.node});
    });
  }

  /// Around the chart and inside, ascending.
  std::vector<Index> curves_at(const SurfaceFeatures& features, const SurfaceCurves& curves) const {
    std::vector<Index> faces;  // features inside may divide a chart
    for (const Index t : chart_.triangles) faces.push_back(features.face[t]);
    sort_unique(faces);
    std::vector<Index> at;
    for (const Index face : faces) {
      const auto row = curves.at_face.row(face);
      at.insert(at.end(), row.begin(), row.end());
    }
    sort_unique(at);
    return at;
  }

  /// Features inside, curve by curve: polylines from node to node.
  void add_inner_features(const SurfaceFeatures& features, const SurfaceCurves& curves,
                          const Atlas& atlas) {
    for (const Index c : curves_at(features, curves)) {
      const auto vertices = curves.vertices.row(c);
      const auto edges = curves.edges.row(c);
      const std::size_t n = edges.size();
      const auto inner = [&](std::size_t k) {
        return inner_half_edge(features.edges, edges[k % n], vertices[k % n], atlas);
      };
      // A loop without a corner begins anywhere: where it leaves this chart, or it closes in it.
      std::size_t first = 0;
      if (curves.is_loop[c])
        while (first < n && inner(first + n - 1) != none) ++first;
      const bool closed = first == n;
      Loop line;
      for (std::size_t k = first; k < first + n; ++k) {
        const Index e = inner(k);
        if (e == none) {
          add_polyline(std::move(line));
          line.clear();
          continue;
        }
        append(e, line);
        if (!closed && (k + 1 == first + n || inner(k + 1) == none)) append_target(e, line);
      }
      if (closed && line.size() > 2) line.push_back(line.front());
      add_polyline(std::move(line));
    }
  }

  /// Corners away from all lines: parts of the surface meet there in one point.
  void add_inner_points(const SurfaceFeatures& features) {
    std::vector<char> on_line(chart_.plane.points.size(), 0);
    const Index sides = 3 * chart_.plane.triangle_count();
    for (Index e = 0; e < sides; ++e)
      if (features.half_edge_is_feature(on_surface(e)))
        on_line[chart_.plane.origin(e)] = on_line[chart_.plane.target(e)] = 1;
    for (std::size_t v = 0; v < on_line.size(); ++v) {
      const Index node = nodes_.at_vertex(chart_.vertex[v]);
      if (on_line[v] || node == none) continue;
      domain_.input.points.push_back({chart_.plane.points[v], ""});
      domain_.places.push_back({chart_.plane.points[v], node});
    }
  }

  void add_polyline(Loop line) {
    if (line.size() > 1) domain_.input.polylines.push_back({std::move(line), ""});
  }

  /// The half-edge of the plane that leaves `from` on this edge, if it lies inside; else none.
  Index inner_half_edge(const SurfaceEdges& edges, Index edge, Index from,
                        const Atlas& atlas) const {
    for (const Index e : edges.half_edges.row(edge)) {
      if (atlas.cut[e] || mesh_.origin(e) != from) continue;
      if (std::binary_search(chart_.triangles.begin(), chart_.triangles.end(), triangle_of(e)))
        return on_plane(e);
    }
    return none;
  }

  void append_target(Index e, Loop& line) {
    const Index next = next_in_triangle(e);
    const Vec2 p = chart_.plane.points[chart_.plane.origin(next)];
    const Index node = nodes_.at_vertex(mesh_.origin(on_surface(next)));
    if (node == none) return;
    line.push_back(p);
    domain_.places.push_back({p, node});
  }

  const SurfaceMesh& mesh_;
  const Chart& chart_;
  const CurveNodes& nodes_;
  ChartDomain domain_;
};

}  // namespace

Index ChartDomain::node_at(Vec2 position) const {
  const auto at =
      std::lower_bound(places.begin(), places.end(), position,
                       [](const Place& place, Vec2 sought) { return place.position < sought; });
  return at != places.end() && at->position == position ? at->node : none;
}

ChartDomain chart_domain(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                         const SurfaceCurves& curves, const Atlas& atlas, const Chart& chart,
                         const CurveNodes& nodes) {
  return DomainMaker(mesh, chart, nodes).run(features, curves, atlas);
}

}  // namespace lpq

// See curve_nodes.h.
#include "shell/curve_nodes.h"

#include <tuple>

#include "base/sort_numbers.h"

namespace lpq {

CurveNodes::CurveNodes(const SurfaceMesh& mesh, const SurfaceEdges& edges,
                       const SurfaceCurves& curves, const CurveMesh& nodes)
    : mesh_(&mesh), edges_(&edges), nodes_(&nodes), start_(edges.ends.size(), none) {
  struct Entry {
    Index edge;
    NodeOnEdge at;
  };
  std::vector<Entry> entries;
  for (Index c = 0; c < curves.count(); ++c) {
    const auto on_curve = curves.edges.row(c);
    for (std::size_t k = 0; k < on_curve.size(); ++k)
      start_[on_curve[k]] = curves.vertices.row(c)[k];
    auto row = nodes.nodes.row(c);
    if (!row.empty()) row = row.first(row.size() - 1);  // the last is a corner, or the first again
    for (const Index node : row) {
      const CurvePlace& place = nodes.places[node];
      if (place.vertex == none) entries.push_back({on_curve[place.edge], {node, place.t}});
    }
  }
  sort_values(entries, [](const Entry& a, const Entry& b) {
    return std::tie(a.edge, a.at.share, a.at.node) < std::tie(b.edge, b.at.share, b.at.node);
  });
  std::size_t next = 0;
  for (Index edge = 0; edge < edges.count(); ++edge) {
    for (; next < entries.size() && entries[next].edge == edge; ++next)
      on_edge_.values.push_back(entries[next].at);
    on_edge_.end_row();
  }
}

}  // namespace lpq

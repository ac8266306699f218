// Writes the dual form out as cells, and the cells as polygons.
#include "voronoi/clipped.h"

#include <algorithm>
#include <utility>

namespace lpq {
namespace {

template <class Visit>
void for_each_fan(const TriMesh& mesh, const ClippedDual& dual, Visit visit) {
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    const Index twin = mesh.twins[e];
    if (twin == none || !dual.is_regular(e, twin)) continue;
    const Index left = triangle_of(e), right = triangle_of(twin);
    visit(FanTriangle{mesh.origin(e), right, left});
    visit(FanTriangle{mesh.target(e), left, right});
  }
  for (const FanTriangle& fan : dual.fans) visit(fan);
}

// Vertices of the diagram without the circumcentres behind walls; returns old index -> new.
std::vector<Index> write_vertices(const TriMesh& mesh, const ClippedDual& dual,
                                  std::vector<VoronoiVertex>& vertices) {
  std::vector<Index> renumbered(dual.vertices.size(), none);
  vertices.clear();
  const Index triangles = mesh.triangle_count();
  for (Index i = 0; i < static_cast<Index>(dual.vertices.size()); ++i) {
    VoronoiVertex vertex{.point = dual.vertices[i]};
    if (i < triangles) {
      if (dual.sheet[i] >= 0) continue;
      if (dual.sheet[i] == ClippedDual::replaced) vertex.kind = VertexKind::corner;
      vertex.sites = mesh.triangles[i];
    } else {
      const RimVertex& rim = dual.rim[i - triangles];
      vertex.kind = rim.kind;
      vertex.sites = {rim.u, rim.v, none};
      vertex.wall = rim.wall;
    }
    renumbered[i] = static_cast<Index>(vertices.size());
    vertices.push_back(vertex);
  }
  return renumbered;
}

// Takes the chain of fan triangles that starts at `start` out of the cell.
std::vector<Vec2> take_chain(const ClippedVoronoi& voronoi, std::vector<FanTriangle>& fans,
                             std::size_t start) {
  std::vector<Vec2> polygon;
  const Index first = fans[start].c1;
  std::size_t at = start;
  for (;;) {
    const Index next = fans[at].c2;
    polygon.push_back(voronoi.vertices[fans[at].c1].point);
    fans.erase(fans.begin() + static_cast<std::ptrdiff_t>(at));
    if (next == first) return polygon;
    const auto follow = std::find_if(fans.begin(), fans.end(),
                                     [&](const FanTriangle& fan) { return fan.c1 == next; });
    if (follow == fans.end()) {
      polygon.push_back(voronoi.vertices[next].point);
      return polygon;
    }
    at = static_cast<std::size_t>(follow - fans.begin());
  }
}

}  // namespace

void clip_voronoi(const TriMesh& mesh, ClippedVoronoi& result) {
  ClippedDual dual;
  clip_dual(mesh, dual);
  const std::vector<Index> renumbered = write_vertices(mesh, dual, result.vertices);
  fill_csr(result.cells, mesh.points.size(), [&](auto&& emit) {
    for_each_fan(mesh, dual, [&](const FanTriangle& fan) {
      emit(fan.site, FanTriangle{fan.site, renumbered[fan.c1], renumbered[fan.c2]});
    });
  });
}

// A cell's fan triangles link up c2 -> c1 into closed outlines, or, at a boundary site, into one
// open chain per fan of Delaunay triangles, closed through the site itself (Fig. 8).
std::vector<std::vector<std::vector<Vec2>>> cell_polygons(const TriMesh& mesh,
                                                          const ClippedVoronoi& voronoi) {
  std::vector<std::vector<std::vector<Vec2>>> polygons(mesh.points.size());
  std::vector<FanTriangle> fans;
  for (Index site = 0; site < mesh.vertex_count(); ++site) {
    const auto row = voronoi.cells.row(site);
    fans.assign(row.begin(), row.end());
    while (!fans.empty()) {
      const auto open = std::find_if(fans.begin(), fans.end(), [&](const FanTriangle& fan) {
        return std::none_of(fans.begin(), fans.end(),
                            [&](const FanTriangle& other) { return other.c2 == fan.c1; });
      });
      const bool closes_at_site = open != fans.end();
      std::vector<Vec2> polygon = take_chain(
          voronoi, fans, static_cast<std::size_t>(closes_at_site ? open - fans.begin() : 0));
      if (closes_at_site) polygon.push_back(mesh.points[site]);
      polygons[site].push_back(std::move(polygon));
    }
  }
  return polygons;
}

}  // namespace lpq

// See check.h.
#include "shell/check.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "shell/sides.h"
#include "surface/edges.h"

namespace lpq {
namespace {

using Edge = std::array<Index, 2>;

class ShellCheck {
 public:
  ShellCheck(const SurfaceMesh& surface, const ShellMesh& mesh, std::size_t limit)
      : surface_(surface),
        surface_edges_(surface_edges(surface.triangles, surface.vertex_count())),
        mesh_(mesh),
        limit_(limit) {}

  std::vector<Violation> run() {
    check_faces();
    if (!violations_.empty()) return std::move(violations_);
    sides_ = sides_by_edge(mesh_.faces);
    check_curves();
    check_edges();
    check_fans();
    if (violations_.empty()) check_euler();
    return std::move(violations_);
  }

 private:
  void check_faces() {
    std::vector<char> used(mesh_.points.size(), 0);
    for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f) {
      const Face& face = mesh_.faces[f];
      for (int k = 0; k < corner_count(face); ++k) {
        used[face[k]] = 1;
        for (int j = 0; j < k; ++j)
          if (face[j] == face[k]) add("A face has a vertex twice.", face[k]);
      }
    }
    for (Index v = 0; v < static_cast<Index>(used.size()); ++v) {
      if (!used[v]) add("A vertex belongs to no face.", none);
      if (!is_finite(mesh_.points[v])) add("A vertex is nowhere.", none);
    }
  }

  void check_curves() {
    for (std::size_t i = 1; i < mesh_.edges.size(); ++i)
      if (mesh_.edges[i] == mesh_.edges[i - 1])
        add("One edge lies on two curves.", mesh_.edges[i][0]);
  }

  /// The place among the edges of curves, or none.
  Index on_curve(const Edge& ends) const {
    const auto at = std::lower_bound(mesh_.edges.begin(), mesh_.edges.end(), ends);
    if (at == mesh_.edges.end() || *at != ends) return none;
    return static_cast<Index>(at - mesh_.edges.begin());
  }

  void check_edges() {
    std::vector<char> met(mesh_.edges.size(), 0);
    for_each_edge(sides_, [&](std::span<const FaceSide> on_edge) {
      Edge faces{0, 0};
      for (const FaceSide& side : on_edge) ++faces[side.forward ? 0 : 1];
      const Edge& ends = on_edge[0].ends;
      const Index curve_edge = on_curve(ends);
      const Edge wanted = curve_edge == none ? Edge{1, 1} : mesh_.sides[curve_edge];
      if (curve_edge != none) met[curve_edge] = 1;
      if (faces[0] > wanted[0] || faces[1] > wanted[1])
        add("An edge has more faces than the surface has there.", ends[0]);
      else if (faces != wanted)
        add("An edge has fewer faces than the surface has there.", ends[0]);
    });
    for (std::size_t i = 0; i < met.size(); ++i)
      if (!met[i]) add("An edge of a curve is no side of a face.", mesh_.edges[i][0]);
  }

  Index wanted_parts(Index v, const std::vector<Index>& parts) const {
    if (mesh_.pins[v] != Pin::corner) return 1;
    const SurfacePlace& place = mesh_.places[v];
    const auto k = std::max_element(place.weight, place.weight + 3) - place.weight;
    return parts[surface_.triangles[place.triangle][k]];
  }

  void check_fans() {
    DisjointSets sets(4 * static_cast<Index>(mesh_.faces.size()));
    for_each_edge(sides_, [&](std::span<const FaceSide> on_edge) {
      for (const FaceSide& side : on_edge.subspan(1))
        for (const Index v : side.ends)
          sets.unite(corner_at(mesh_.faces, on_edge[0], v), corner_at(mesh_.faces, side, v));
    });
    std::vector<Index> fans(mesh_.points.size(), 0);
    for (const FaceSide& side : sides_)
      if (const Index corner = 4 * side.face + side.corner; sets.root(corner) == corner)
        ++fans[mesh_.faces[side.face][side.corner]];
    const std::vector<Index> parts =
        parts_at_vertices(surface_.triangles, surface_edges_, surface_.vertex_count());
    for (Index v = 0; v < static_cast<Index>(fans.size()); ++v)
      if (fans[v] != wanted_parts(v, parts)) add("The faces at a vertex do not hang together.", v);
  }

  void check_euler() {
    std::vector<char> used(surface_.points.size(), 0);
    for (const Tri& t : surface_.triangles)
      for (const Index v : t) used[v] = 1;
    const auto wanted = std::count(used.begin(), used.end(), 1) - surface_edges_.count() +
                        static_cast<std::ptrdiff_t>(surface_.triangles.size());
    std::ptrdiff_t edges = 0;
    for_each_edge(sides_, [&edges](std::span<const FaceSide>) { ++edges; });
    const auto got = static_cast<std::ptrdiff_t>(mesh_.points.size()) - edges +
                     static_cast<std::ptrdiff_t>(mesh_.faces.size());
    if (wanted != got)
      add("The mesh has Euler number " + std::to_string(got) + ", the surface " +
              std::to_string(wanted) + ".",
          none);
  }

  void add(std::string what, Index vertex) {
    if (violations_.size() < limit_) violations_.push_back({std::move(what), none, vertex, {}});
  }

  const SurfaceMesh& surface_;
  const SurfaceEdges surface_edges_;
  const ShellMesh& mesh_;
  std::size_t limit_;
  std::vector<FaceSide> sides_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> check_shell(const SurfaceMesh& surface, const ShellMesh& mesh,
                                   std::size_t limit) {
  return ShellCheck(surface, mesh, limit).run();
}

}  // namespace lpq

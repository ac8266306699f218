// See check.h.
#include "shell/check.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "surface/edges.h"
#include "surface/weld.h"

namespace lpq {
namespace {

using Edge = std::array<Index, 2>;

/// A side of a face.
struct Side {
  Edge ends;     // ascending
  bool forward;  // from the first of them to the second
  Index corner;  // 4 * face + number: where it starts

  bool operator<(const Side& other) const {
    return ends != other.ends ? ends < other.ends : corner < other.corner;
  }
};

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
    find_sides();
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

  void find_sides() {
    for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f) {
      const Face& face = mesh_.faces[f];
      for (int k = 0; k < corner_count(face); ++k) {
        const Index a = face[k], b = face[(k + 1) % corner_count(face)];
        sides_.push_back({{std::min(a, b), std::max(a, b)}, a < b, 4 * f + k});
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }

  /// Calls visit(first, last) for the sides on each edge.
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (std::size_t i = 0, j = 0; i < sides_.size(); i = j) {
      while (j < sides_.size() && sides_[j].ends == sides_[i].ends) ++j;
      visit(i, j);
    }
  }

  void check_curves() {
    for (std::size_t i = 1; i < mesh_.edges.size(); ++i)
      if (mesh_.edges[i] == mesh_.edges[i - 1])
        add("One edge lies on two curves.", mesh_.edges[i][0]);
  }

  Edge wanted_faces(const Edge& ends) const {
    const auto at = std::lower_bound(mesh_.edges.begin(), mesh_.edges.end(), ends);
    if (at == mesh_.edges.end() || *at != ends) return {1, 1};
    return mesh_.sides[at - mesh_.edges.begin()];
  }

  void check_edges() {
    for_each_edge([this](std::size_t first, std::size_t last) {
      Edge faces{0, 0};
      for (std::size_t i = first; i < last; ++i) ++faces[sides_[i].forward ? 0 : 1];
      const Edge& ends = sides_[first].ends;
      const Edge wanted = wanted_faces(ends);
      if (faces[0] > wanted[0] || faces[1] > wanted[1])
        add("An edge has more faces than the surface has there.", ends[0]);
      else if (faces != wanted)
        add("An edge has fewer faces than the surface has there.", ends[0]);
    });
  }

  /// The corner of a side's face at one of its ends.
  Index corner_at(const Side& side, Index vertex) const {
    const Index face = side.corner / 4, k = side.corner % 4;
    return mesh_.faces[face][k] == vertex ? side.corner
                                          : 4 * face + (k + 1) % corner_count(mesh_.faces[face]);
  }

  Index wanted_parts(Index v, const std::vector<Index>& parts) const {
    if (mesh_.pinned[v] != 2) return 1;
    const SurfacePlace& place = mesh_.places[v];
    const auto k = std::max_element(place.weight, place.weight + 3) - place.weight;
    return parts[surface_.triangles[place.triangle][k]];
  }

  void check_fans() {
    DisjointSets sets(4 * static_cast<Index>(mesh_.faces.size()));
    for_each_edge([&](std::size_t first, std::size_t last) {
      for (std::size_t i = first + 1; i < last; ++i)
        for (const Index v : sides_[first].ends)
          sets.unite(corner_at(sides_[first], v), corner_at(sides_[i], v));
    });
    std::vector<Index> fans(mesh_.points.size(), 0);
    for (const Side& side : sides_)
      if (sets.root(side.corner) == side.corner)
        ++fans[mesh_.faces[side.corner / 4][side.corner % 4]];
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
    for_each_edge([&edges](std::size_t, std::size_t) { ++edges; });
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
  std::vector<Side> sides_;  // by their edges
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> check_shell(const SurfaceMesh& surface, const ShellMesh& mesh,
                                   std::size_t limit) {
  return ShellCheck(surface, mesh, limit).run();
}

std::vector<Violation> check_places(const ShellMesh& mesh, double diagonal, std::size_t limit) {
  constexpr double one_point = 1e-12;
  std::vector<Violation> found;
  const std::vector<char> all(mesh.points.size(), 1);
  const std::vector<Index> first = weld_points(mesh.points, all, one_point * diagonal);
  for (Index v = 0; v < static_cast<Index>(first.size()) && found.size() < limit; ++v)
    if (first[v] != v) found.push_back({"Two vertices lie in one point.", none, v, {}});
  std::vector<Face> faces = mesh.faces;
  for (Face& face : faces) std::sort(face.begin(), face.end());
  std::sort(faces.begin(), faces.end());
  for (std::size_t f = 1; f < faces.size() && found.size() < limit; ++f)
    if (faces[f] == faces[f - 1])
      found.push_back({"Two faces have the same vertices.", none, faces[f][3], {}});
  return found;
}

}  // namespace lpq

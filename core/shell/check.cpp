// See check.h.
#include "shell/check.h"

#include <algorithm>

namespace lpq {
namespace {

using Edge = std::array<Index, 2>;

class ShellCheck {
 public:
  ShellCheck(const ShellMesh& mesh, std::size_t limit) : mesh_(mesh), limit_(limit) {}

  void check_faces() {
    std::vector<char> used(mesh_.points.size(), 0);
    for (Index f = 0; f < static_cast<Index>(mesh_.faces.size()); ++f) {
      const Face& face = mesh_.faces[f];
      for (int k = 0; k < corner_count(face); ++k) {
        used[face[k]] = 1;
        for (int j = 0; j < k; ++j)
          if (face[j] == face[k]) add("A face has a vertex twice.", f, face[k]);
      }
    }
    for (Index v = 0; v < static_cast<Index>(used.size()); ++v) {
      if (!used[v]) add("A vertex belongs to no face.", none, v);
      if (!is_finite(mesh_.points[v])) add("A vertex is nowhere.", none, v);
    }
  }

  void check_edges() {
    std::vector<Edge> directed;
    for (const Face& face : mesh_.faces)
      for (int k = 0; k < corner_count(face); ++k)
        directed.push_back({face[k], face[(k + 1) % corner_count(face)]});
    std::sort(directed.begin(), directed.end());
    for (std::size_t i = 0; i < directed.size(); ++i) {
      const auto [a, b] = directed[i];
      if (std::binary_search(mesh_.edges.begin(), mesh_.edges.end(),
                             Edge{std::min(a, b), std::max(a, b)}))
        continue;  // features: what lies there is judged by the Euler number
      if (i > 0 && directed[i - 1] == directed[i])
        add("Two faces lie on the same side of an edge.", none, a);
      if (!std::binary_search(directed.begin(), directed.end(), Edge{b, a}))
        add("An edge inside the surface has one face only.", none, a);
    }
    for (Edge& e : directed)
      if (e[0] > e[1]) std::swap(e[0], e[1]);
    std::sort(directed.begin(), directed.end());
    edge_count_ = std::unique(directed.begin(), directed.end()) - directed.begin();
  }

  void check_euler(const SurfaceMesh& surface) {
    std::vector<Edge> edges;
    std::vector<char> used(surface.points.size(), 0);
    for (const Tri& t : surface.triangles)
      for (int k = 0; k < 3; ++k) {
        used[t[k]] = 1;
        const Index a = t[k], b = t[(k + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b)});
      }
    std::sort(edges.begin(), edges.end());
    const auto count = std::unique(edges.begin(), edges.end()) - edges.begin();
    const auto wanted = std::count(used.begin(), used.end(), 1) - count +
                        static_cast<std::ptrdiff_t>(surface.triangles.size());
    const auto got = static_cast<std::ptrdiff_t>(mesh_.points.size()) - edge_count_ +
                     static_cast<std::ptrdiff_t>(mesh_.faces.size());
    if (wanted != got)
      add("The mesh has Euler number " + std::to_string(got) + ", the surface " +
              std::to_string(wanted) + ".",
          none, none);
  }

  std::vector<Violation> take() { return std::move(violations_); }

 private:
  void add(std::string what, Index face, Index vertex) {
    if (violations_.size() < limit_) violations_.push_back({std::move(what), face, vertex, {}});
  }

  const ShellMesh& mesh_;
  std::size_t limit_;
  std::ptrdiff_t edge_count_ = 0;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> check_shell(const SurfaceMesh& surface, const ShellMesh& mesh,
                                   std::size_t limit) {
  ShellCheck check(mesh, limit);
  check.check_faces();
  check.check_edges();
  check.check_euler(surface);
  return check.take();
}

}  // namespace lpq

// See edge_sides.h.
#include "io/mesh/edge_sides.h"

#include <algorithm>
#include <array>

namespace lpq {
namespace {

/// Edges by their directed ends.
class EdgeTable {
 public:
  explicit EdgeTable(const OutputMesh& mesh) : on_edge_(mesh.points.size(), 0) {
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const OutputEdge& edge = mesh.edges[e];
      entries_.push_back({edge.a, edge.b, static_cast<Index>(e)});
      on_edge_[static_cast<std::size_t>(edge.a)] = on_edge_[static_cast<std::size_t>(edge.b)] = 1;
    }
    std::sort(entries_.begin(), entries_.end());
  }

  Index find(Index a, Index b) const {
    // Most mesh edges end at a point that is on no edge of the 1D mesh.
    if (!on_edge_[static_cast<std::size_t>(a)] || !on_edge_[static_cast<std::size_t>(b)])
      return none;
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), std::array{a, b, Index{0}});
    return at != entries_.end() && (*at)[0] == a && (*at)[1] == b ? (*at)[2] : none;
  }

 private:
  std::vector<char> on_edge_;                  // #V
  std::vector<std::array<Index, 3>> entries_;  // from, to, edge
};

}  // namespace

std::vector<EdgeSide> edge_sides(const OutputMesh& mesh) {
  const EdgeTable table(mesh);
  std::vector<EdgeSide> sides(mesh.edges.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    for (int k = 0, n = corner_count(face); k < n; ++k) {
      const Index a = face[k], b = face[(k + 1) % n];
      const Index left = table.find(a, b), right = table.find(b, a);
      if (left != none) sides[static_cast<std::size_t>(left)] = {static_cast<Index>(f), k};
      if (right == none) continue;
      EdgeSide& other = sides[static_cast<std::size_t>(right)];
      if (other.face == none) other = {static_cast<Index>(f), k};
    }
  }
  return sides;
}

}  // namespace lpq

// Why the witness offers a triangle to split: in a connected part of even size without a perfect
// matching the witness W leaves at least |W| + 2 odd pieces, each next to W. If every triangle in W
// touched one odd piece at most there would be no more than |W|, so some triangle touches two or
// three. Split in three, it serves every piece it touches; a part that faces an even piece joins
// it, which mostly but not always helps. The path from one unmatched triangle to another always
// does.
#include "recombine/repair.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "recombine/edit.h"

namespace lpq {
namespace {

constexpr Index even_piece = -2;

/// Number of the odd piece of each node when the witness is removed; even_piece, or none for the
/// witness itself.
std::vector<Index> odd_pieces(const DualGraph& graph, const std::vector<Index>& witness) {
  DisjointSets pieces(graph.nodes);
  std::vector<char> removed(static_cast<std::size_t>(graph.nodes), 0);
  for (Index v : witness) removed[v] = 1;
  for (const CostEdge& edge : graph.edges)
    if (!removed[edge.u] && !removed[edge.v]) pieces.unite(edge.u, edge.v);
  std::vector<Index> size(static_cast<std::size_t>(graph.nodes), 0), result(size.size());
  for (Index v = 0; v < graph.nodes; ++v) ++size[pieces.root(v)];
  for (Index v = 0; v < graph.nodes; ++v) {
    const Index r = pieces.root(v);
    result[v] = removed[v] ? none : size[r] % 2 == 1 ? r : even_piece;
  }
  return result;
}

class NearestWitness {
 public:
  NearestWitness(const TriMesh& mesh, const DualGraph& graph, const Matching& matching)
      : mesh_(mesh), piece_(odd_pieces(graph, matching.witness)) {
    seen_.assign(mesh.triangles.size(), none);
    taken_.assign(mesh.triangles.size(), 0);
  }

  /// Breadth first from `start`: the first free witness triangle between two or three odd pieces.
  Index find(Index start) {
    std::vector<Index> queue{start};
    seen_[start] = start;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Index t = queue[i];
      if (piece_[t] == none && !taken_[t] && pieces_around(t) >= 2) {
        taken_[t] = 1;
        return t;
      }
      for (Index e = 3 * t; e < 3 * t + 3; ++e) {
        const Index twin = mesh_.twins[e];
        if (twin == none || seen_[triangle_of(twin)] == start) continue;
        seen_[triangle_of(twin)] = start;
        queue.push_back(triangle_of(twin));
      }
    }
    return none;
  }

  /// Number of different odd pieces across the edges of triangle t.
  Index pieces_around(Index t) const {
    Index found[3];
    Index count = 0;
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      if (mesh_.twins[e] == none) continue;
      const Index p = piece_[triangle_of(mesh_.twins[e])];
      if (p >= 0 && std::find(found, found + count, p) == found + count) found[count++] = p;
    }
    return count;
  }

 private:
  const TriMesh& mesh_;
  std::vector<Index> piece_;
  std::vector<Index> seen_;  // start of the search that reached this triangle last
  std::vector<char> taken_;
};

/// A triangle between n odd pieces serves n - 1 of them more than it did whole.
std::vector<Index> choose_splits(const TriMesh& mesh, const DualGraph& graph,
                                 const Matching& matching) {
  NearestWitness witness(mesh, graph, matching);
  std::vector<Index> chosen;
  Index unserved = matching.deficiency;
  for (Index t = 0; t < mesh.triangle_count() && unserved > 0; ++t) {
    if (matching.mate[t] != none) continue;
    const Index found = witness.find(t);
    if (found == none) continue;
    unserved -= witness.pieces_around(found) - 1;
    chosen.push_back(found);
  }
  return chosen;
}

/// Shortest ways across inner edges from one unmatched triangle to the next, each triangle on one
/// way at most.
class Ways {
 public:
  Ways(const TriMesh& mesh, const Matching& matching) : mesh_(mesh), mate_(matching.mate) {
    taken_.assign(mesh.triangles.size(), 0);
    from_.assign(mesh.triangles.size(), none);
    start_.assign(mesh.triangles.size(), none);
  }

  /// Triangles from `start` to the nearest unmatched one; empty if none can be reached.
  std::vector<Index> find(Index start) {
    std::vector<Index> queue{start};
    start_[start] = start;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Index e = 3 * queue[i]; e < 3 * queue[i] + 3; ++e) {
        const Index next = mesh_.twins[e] == none ? none : triangle_of(mesh_.twins[e]);
        if (next == none || taken_[next] || start_[next] == start) continue;
        start_[next] = start;
        from_[next] = queue[i];
        if (mate_[next] == none) return trace(next, start);
        queue.push_back(next);
      }
    return {};
  }

  bool taken(Index t) const { return taken_[t] != 0; }

 private:
  std::vector<Index> trace(Index end, Index start) {
    std::vector<Index> way;
    for (Index t = end;; t = from_[t]) {
      way.push_back(t);
      taken_[t] = 1;
      if (t == start) break;
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  const TriMesh& mesh_;
  const std::vector<Index>& mate_;
  std::vector<char> taken_;
  std::vector<Index> from_, start_;
};

}  // namespace

Index split_witness(TriMesh& mesh, const DualGraph& graph, const Matching& matching) {
  const std::vector<Index> chosen = choose_splits(mesh, graph, matching);
  for (Index t : chosen) split_triangle(mesh, t);
  return static_cast<Index>(chosen.size());
}

Index split_ways(TriMesh& mesh, const Matching& matching) {
  const Index triangles = mesh.triangle_count();
  Ways ways(mesh, matching);
  std::vector<Index> chosen;
  for (Index t = 0; t < triangles; ++t) {
    if (matching.mate[t] != none || ways.taken(t)) continue;
    const std::vector<Index> way = ways.find(t);
    for (std::size_t i = 1; i + 1 < way.size(); ++i)
      if (matching.mate[way[i]] == way[i + 1])
        ++i;  // the unmatched triangle moves on by exchanging partners
      else
        chosen.push_back(way[i]);
  }
  for (Index t : chosen) split_triangle(mesh, t);
  return static_cast<Index>(chosen.size());
}

}  // namespace lpq

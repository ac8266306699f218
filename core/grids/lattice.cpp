// See lattice.h.
#include "grids/lattice.h"

#include <algorithm>
#include <array>

namespace lpq {
namespace {

class Lattice {
 public:
  /// Of places from `low` to `high`; of those rows only as many as go `round`.
  Lattice(LatticePlace low, LatticePlace high, Index round)
      : low_(low),
        width_(high.x - low.x + 1),
        height_(round > 0 ? round : high.y - low.y + 1),
        round_(round > 0) {
    vertex_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), none);
    rises_.assign(vertex_.size(), 0);
  }

  bool lay(const LatticeLoop& loop) {
    const std::size_t n = loop.nodes.size();
    for (std::size_t k = 0; k < n; ++k) {
      const LatticePlace p = of_rows(loop.places[k]), q = of_rows(loop.places[(k + 1) % n]);
      if (vertex_[at(p)] != none) return false;
      vertex_[at(p)] = loop.nodes[k];
      if (q == above(p)) ++rises_[at(p)];
      if (p == above(q)) --rises_[at(q)];
    }
    return true;
  }

  std::optional<LatticeQuads> fill(Index node_count) {
    LatticeQuads quads;
    for (Index y = 0; y + (round_ ? 0 : 1) < height_; ++y) {
      // From right to left: into the domain across every line that rises, out across one that
      // falls.
      int winding = 0;
      for (Index x = width_ - 1; x > 0; --x) {
        winding += rises_[at({x, y})];
        if (winding < 0 || winding > 1) return std::nullopt;
        if (winding == 1) add({x - 1, y}, node_count, quads);
      }
    }
    return quads;
  }

 private:
  std::size_t at(LatticePlace p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(p.x);
  }

  LatticePlace of_rows(LatticePlace place) const {
    place = place - low_;
    if (round_) place.y = (place.y % height_ + height_) % height_;
    return place;
  }

  LatticePlace above(LatticePlace p) const {
    return {p.x, round_ && p.y + 1 == height_ ? 0 : p.y + 1};
  }

  void add(LatticePlace low, Index node_count, LatticeQuads& quads) {
    const LatticePlace right{low.x + 1, low.y};
    Face face;
    std::size_t k = 0;
    for (const LatticePlace corner : {low, right, above(right), above(low)}) {
      Index& v = vertex_[at(corner)];
      if (v == none) v = node_count + quads.inside++;
      face[k++] = v;
    }
    quads.faces.push_back(face);
  }

  LatticePlace low_;
  Index width_, height_;
  bool round_;
  std::vector<Index> vertex_;  // at each place
  std::vector<int> rises_;     // lines up from each place less lines down to it
};

}  // namespace

LatticePlace lattice_step(Index direction) {
  constexpr std::array<LatticePlace, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return steps[static_cast<std::size_t>(direction & 3)];
}

std::optional<LatticeQuads> lattice_quads(const LaidLoops& laid, Index node_count, double most) {
  LatticePlace low = laid.loops[0].places[0], high = low;
  for (const LatticeLoop& loop : laid.loops)
    for (const LatticePlace p : loop.places) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const Index rows = laid.round > 0 ? laid.round : high.y - low.y + 1;
  if ((high.x - low.x + 1.0) * rows > most) return std::nullopt;
  Lattice lattice(low, high, laid.round);
  for (const LatticeLoop& loop : laid.loops)
    if (!lattice.lay(loop)) return std::nullopt;
  return lattice.fill(node_count);
}

}  // namespace lpq

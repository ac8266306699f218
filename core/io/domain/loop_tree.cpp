// A sweep from left to right that keeps the edges it cuts in order from below to above [de Berg et
// al. 2008, 2.1]. Where a loop is first met, the edge directly below its lower edge says what it
// lies in: if that edge's loop is above it, in that loop; else beside that loop, in the same one.
#include "io/domain/loop_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "geometry/frame.h"
#include "geometry/polygon.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

struct SweptEdge {
  Vec2 left, right;  // left < right
  Index loop;
  bool inside_above;
};

class Sweep {
 public:
  Sweep(std::span<const std::vector<Vec2>> loops, std::span<const Vec2> probes);
  LoopTree run();

 private:
  /// From below to above, for edges that a common sweep line cuts.
  struct Below {
    const Sweep* sweep;
    using is_transparent = void;
    bool operator()(Index e, Index f) const { return sweep->is_below(e, f); }
    bool operator()(Index e, Vec2 p) const {
      const SweptEdge& edge = sweep->edges_[e];
      return orient2d(edge.left, edge.right, p) > 0;
    }
    bool operator()(Vec2 p, Index e) const { return !(*this)(e, p); }
  };
  using Cut = std::set<Index, Below>;

  bool is_below(Index e, Index f) const;
  bool coincident_below(Index e, Index f) const;
  void add_loop(const std::vector<Vec2>& loop, const UnitFrame& frame);
  void settle_starts(std::size_t begin, std::size_t end);
  Index loop_above(Cut::const_iterator at, const Cut& cut) const;

  std::vector<SweptEdge> edges_;
  std::vector<double> area_;   // of each loop, unsigned
  std::vector<char> settled_;  // the loop has been met
  std::vector<Vec2> probes_;   // in the frame
  std::vector<Cut::iterator> position_;
  std::vector<Index> starts_;  // edges by their left ends
  LoopTree tree_;
  Cut cut_{Below{this}};
};

Sweep::Sweep(std::span<const std::vector<Vec2>> loops, std::span<const Vec2> probes) {
  std::vector<Vec2> corners(probes.begin(), probes.end());
  for (const std::vector<Vec2>& loop : loops)
    for (const Vec2 p : loop) corners.push_back(p);
  const UnitFrame frame = fit_frame(corners);
  for (const std::vector<Vec2>& loop : loops) add_loop(loop, frame);
  for (const Vec2 p : probes) probes_.push_back(frame.to_frame(p));
  tree_.parent.assign(loops.size(), none);
  tree_.depth.assign(loops.size(), 0);
  tree_.around.assign(probes.size(), none);
  settled_.assign(loops.size(), 0);
}

void Sweep::add_loop(const std::vector<Vec2>& loop, const UnitFrame& frame) {
  std::vector<Vec2> polygon;
  for (const Vec2 p : loop) polygon.push_back(frame.to_frame(p));
  const bool counter_clockwise = orientation(polygon) >= 0;
  const auto number = static_cast<Index>(area_.size());
  area_.push_back(std::abs(signed_area(polygon)));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if (a == b) continue;
    const bool forward = a < b;
    edges_.push_back({forward ? a : b, forward ? b : a, number, forward == counter_clockwise});
  }
}

/// Edges that run along the same line: upper ends of loops below lower ones, so that neighbours are
/// beside each other; a loop's lower edge below that of a smaller loop, its upper edge above.
bool Sweep::coincident_below(Index e, Index f) const {
  const SweptEdge &one = edges_[e], &two = edges_[f];
  if (one.inside_above != two.inside_above) return two.inside_above;
  const auto larger = [this](Index a, Index b) {
    return area_[a] != area_[b] ? area_[a] > area_[b] : a < b;
  };
  if (one.loop == two.loop) return e < f;
  return one.inside_above ? larger(one.loop, two.loop) : larger(two.loop, one.loop);
}

bool Sweep::is_below(Index e, Index f) const {
  if (e == f) return false;
  const SweptEdge &one = edges_[e], &two = edges_[f];
  if (two.left < one.left) {
    int side = orient2d(two.left, two.right, one.left);
    if (side == 0) side = orient2d(two.left, two.right, one.right);
    return side == 0 ? coincident_below(e, f) : side < 0;
  }
  int side = orient2d(one.left, one.right, two.left);
  if (side == 0) side = orient2d(one.left, one.right, two.right);
  return side == 0 ? coincident_below(e, f) : side > 0;
}

/// The loop that fills the place directly above the edge before `at`.
Index Sweep::loop_above(Cut::const_iterator at, const Cut& cut) const {
  if (at == cut.begin()) return none;
  const SweptEdge& below = edges_[*--at];
  return below.inside_above ? below.loop : tree_.parent[below.loop];
}

/// starts_[begin .. end) have one left end and are in the cut: loops met for the first time there
/// are settled from below to above.
void Sweep::settle_starts(std::size_t begin, std::size_t end) {
  std::stable_sort(starts_.begin() + static_cast<std::ptrdiff_t>(begin),
                   starts_.begin() + static_cast<std::ptrdiff_t>(end),
                   [this](Index e, Index f) { return is_below(e, f); });
  for (std::size_t i = begin; i < end; ++i) {
    const Index loop = edges_[starts_[i]].loop;
    if (settled_[loop]) continue;
    settled_[loop] = 1;
    if (position_[starts_[i]] == cut_.end()) continue;
    const Index parent = loop_above(position_[starts_[i]], cut_);
    if (parent == none || parent == loop || !settled_[parent]) continue;
    tree_.parent[loop] = parent;
    tree_.depth[loop] = tree_.depth[parent] + 1;
  }
}

LoopTree Sweep::run() {
  std::vector<Index> ends(edges_.size()), probes(probes_.size());
  std::iota(ends.begin(), ends.end(), 0);
  std::iota(probes.begin(), probes.end(), 0);
  starts_ = ends;
  position_.assign(edges_.size(), cut_.end());
  std::stable_sort(starts_.begin(), starts_.end(),
                   [&](Index e, Index f) { return edges_[e].left < edges_[f].left; });
  std::stable_sort(ends.begin(), ends.end(),
                   [&](Index e, Index f) { return edges_[e].right < edges_[f].right; });
  std::stable_sort(probes.begin(), probes.end(),
                   [&](Index i, Index j) { return probes_[i] < probes_[j]; });
  std::size_t start = 0, end = 0;
  const auto advance = [&](Vec2 to) {  // everything before `to`, and what ends there
    while (true) {
      const bool more = start < starts_.size() && edges_[starts_[start]].left < to;
      const Vec2 at = more ? edges_[starts_[start]].left : to;
      while (end < ends.size() && !(at < edges_[ends[end]].right)) {
        const Index done = ends[end++];
        if (position_[done] != cut_.end()) cut_.erase(position_[done]);
      }
      if (!more) return;
      const std::size_t begin = start;
      for (; start < starts_.size() && edges_[starts_[start]].left == at; ++start) {
        const auto [place, is_new] = cut_.insert(starts_[start]);
        if (is_new) position_[starts_[start]] = place;  // always, unless loops cross
      }
      settle_starts(begin, start);
    }
  };
  for (const Index i : probes) {
    advance(probes_[i]);
    tree_.around[i] = loop_above(cut_.lower_bound(probes_[i]), cut_);
  }
  if (!ends.empty()) advance(edges_[ends.back()].right);
  return std::move(tree_);
}

}  // namespace

LoopTree nest_loops(std::span<const std::vector<Vec2>> loops, std::span<const Vec2> probes) {
  return Sweep(loops, probes).run();
}

}  // namespace lpq

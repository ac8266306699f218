#include "surface/flat.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "surface/edges.h"

namespace lpq {
namespace {

using Ends = std::array<Index, 2>;

Ends sorted_ends(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// An edge by its length; equal lengths by the vertices.
struct Length {
  double squared = 0;
  Ends ends{none, none};
  bool operator<(const Length& other) const {
    return squared != other.squared ? squared < other.squared : ends < other.ends;
  }
};

bool repeats(const Tri& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

class Remover {
 public:
  Remover(std::span<const Vec3> points, double height, std::vector<Tri>& triangles,
          std::vector<Index>& group)
      : points_(points), height_(height), triangles_(triangles), group_(group) {
    for (Index t = 0; t < static_cast<Index>(triangles_.size()); ++t) {
      if (!is_flat_cap(t)) continue;
      flat_.insert({longest_edge(t), t});
    }
    if (flat_.empty()) return;
    alive_.assign(triangles_.size(), 1);
    edges_ = surface_edges(triangles_, static_cast<Index>(points_.size()));
  }

  FlatRemoval run() {
    // The theory needs no limit; rounding could make a circle of it.
    constexpr std::size_t patience = 16;
    std::size_t steps = patience * flat_.size();
    while (!flat_.empty() && steps-- > 0) remove(std::prev(flat_.end())->second);
    if (!alive_.empty()) compact();
    for (const Tri& t : triangles_) result_.left += is_flat_at(t);
    return result_;
  }

 private:
  bool is_flat_at(const Tri& t) const {
    return is_flat(points_[t[0]], points_[t[1]], points_[t[2]], height_);
  }
  double squared_edge(Index a, Index b) const { return squared_length(points_[a] - points_[b]); }

  bool is_flat_cap(Index i) const {
    const Tri& t = triangles_[i];
    if (!is_flat_at(t)) return false;
    const double shortest =
        std::min({squared_edge(t[0], t[1]), squared_edge(t[1], t[2]), squared_edge(t[2], t[0])});
    return shortest > height_ * height_;
  }

  Length longest_edge(Index i) const {
    Length longest;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangles_[i][k], b = triangles_[i][(k + 1) % 3];
      longest = std::max(longest, Length{squared_edge(a, b), sorted_ends(a, b)});
    }
    return longest;
  }

  void leave(Index i) {
    flat_.erase({longest_edge(i), i});
    alive_[i] = 0;
  }

  /// Triangles on an edge: those of the start, and those that came since.
  std::vector<Index> triangles_on(Ends ends) const {
    std::vector<Index> list;
    const auto at = std::lower_bound(edges_.ends.begin(), edges_.ends.end(), ends);
    if (at != edges_.ends.end() && *at == ends)
      for (const Index e : edges_.half_edges.row(static_cast<Index>(at - edges_.ends.begin())))
        list.push_back(triangle_of(e));
    if (const auto found = added_.find(ends); found != added_.end())
      list.insert(list.end(), found->second.begin(), found->second.end());
    std::erase_if(list, [this](Index i) { return !alive_[i]; });
    return list;
  }

  void add(const Tri& corners, Index group) {
    if (repeats(corners)) return;
    const Index i = static_cast<Index>(triangles_.size());
    triangles_.push_back(corners);
    group_.push_back(group);
    alive_.push_back(1);
    for (std::size_t k = 0; k < 3; ++k)
      added_[sorted_ends(corners[k], corners[(k + 1) % 3])].push_back(i);
    if (is_flat_cap(i)) flat_.insert({longest_edge(i), i});
  }

  void remove(Index i) {
    const Ends ends = longest_edge(i).ends;
    const Tri t = triangles_[i];
    const Index apex = t[0] + t[1] + t[2] - ends[0] - ends[1];
    leave(i);
    ++result_.removed;
    for (const Index other : triangles_on(ends)) divide(other, ends, apex);
  }

  void divide(Index i, Ends ends, Index apex) {
    const Tri t = triangles_[i];
    const Index group = group_[i];
    leave(i);
    ++result_.divided;
    for (const Index gone : ends) {
      Tri half = t;
      std::replace(half.begin(), half.end(), gone, apex);
      add(half, group);
    }
  }

  void compact() {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!alive_[t]) continue;
      triangles_[kept] = triangles_[t];
      group_[kept++] = group_[t];
    }
    triangles_.resize(kept);
    group_.resize(kept);
  }

  std::span<const Vec3> points_;
  double height_;
  std::vector<Tri>& triangles_;
  std::vector<Index>& group_;
  std::vector<char> alive_;
  SurfaceEdges edges_;                        // of the triangles given
  std::map<Ends, std::vector<Index>> added_;  // triangles that came since, on their edges
  std::set<std::pair<Length, Index>> flat_;
  FlatRemoval result_;
};

}  // namespace

bool is_flat(Vec3 a, Vec3 b, Vec3 c, double height) {
  const double longest =
      std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
  return squared_length(cross(b - a, c - a)) <= height * height * longest;
}

FlatRemoval remove_flat_triangles(std::span<const Vec3> points, double height,
                                  std::vector<Tri>& triangles, std::vector<Index>& group) {
  return Remover(points, height, triangles, group).run();
}

}  // namespace lpq

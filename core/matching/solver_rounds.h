// The schedule of searches. Part of BlossomSolver, see solver.h.
#pragma once

#include <algorithm>
#include <utility>

#include "base/sort_numbers.h"
#include "matching/solver.h"

namespace lpq {

template <class Int>
BlossomSolver<Int>::BlossomSolver(Index node_count, std::span<const CostEdge> edges,
                                  std::span<const Index> new_id)
    : node_count_(node_count), row_(node_count + 1), arcs_(2 * edges.size()) {
  for (const CostEdge& e : edges) {
    ++row_[new_id[e.u]];
    ++row_[new_id[e.v]];
  }
  Index total = 0;
  for (Index& start : row_) start = std::exchange(total, total + start);
  std::vector<Index> free(row_.begin(), row_.end() - 1);
  for (const CostEdge& e : edges) {
    const Index u = new_id[e.u], v = new_id[e.v];
    const Index a = free[u]++, b = free[v]++;
    arcs_[a] = {v, b, static_cast<Int>(2 * e.cost)};
    arcs_[b] = {u, a, static_cast<Int>(2 * e.cost)};
  }
  nodes_.resize(node_count);
  sets_.resize(node_count);
  members_.resize(node_count, {none, none, none, none, none, none, 0});
  for (Index v = 0; v < node_count; ++v) {
    nodes_[v] = {0, v};
    sets_[v] = {0, v, Label::exposed};
    members_[v].set = v;
  }
}

/// Duals from the cheapest arcs, then for each exposed node the smallest slack as a further gain;
/// tight arcs between exposed nodes are matched at once. Leaves some 15 % exposed on meshes.
template <class Int>
void BlossomSolver<Int>::greedy_start() {
  for (Index v = 0; v < node_count_; ++v) {
    if (row_[v] == row_[v + 1]) continue;
    Int cheapest = arcs_[row_[v]].cost;
    for (Index arc = row_[v]; arc < row_[v + 1]; ++arc) {
      cheapest = std::min(cheapest, arcs_[arc].cost);
    }
    nodes_[v].potential = cheapest / 2;  // costs are even
  }
  for (Index v = 0; v < node_count_; ++v) {
    if (members_[v].mate != none || row_[v] == row_[v + 1]) continue;
    Index best = none;
    Int smallest = 0;
    for (Index arc = row_[v]; arc < row_[v + 1]; ++arc) {
      const Index to = arcs_[arc].to;
      const Int gap = arcs_[arc].cost - nodes_[v].potential - nodes_[to].potential;
      if (best == none || gap < smallest || (gap == smallest && members_[to].mate == none)) {
        best = arc;
        smallest = gap;
      }
    }
    nodes_[v].potential += smallest;
    const Index to = arcs_[best].to;
    if (members_[to].mate != none) continue;
    members_[v].mate = best;
    members_[to].mate = arcs_[best].reverse;
    sets_[v].label = sets_[to].label = Label::matched;
  }
}

/// Searches in rounds of slowly growing radius, so that all trees stay about equally large, as if
/// they grew at once: exposed nodes then find each other early. Measured on meshes, growing by 1/16
/// makes half as many blossoms as by 1/4; the restarts it costs are of small trees.
template <class Int>
void BlossomSolver<Int>::solve() {
  greedy_start();
  std::vector<Index> roots;
  for (Index v = 0; v < node_count_; ++v) {
    if (members_[v].mate == none) roots.push_back(v);
  }
  for (Int radius = first_radius(); !roots.empty();) {
    const std::size_t before = roots.size();
    search_all(roots, radius);
    if (radius == range && !roots.empty()) range_exceeded_ = true;
    if (range_exceeded_) return;
    // Hardly any progress: the radius is far from the scale of the costs.
    const bool stalled = (before - roots.size()) * 64 < before;
    radius =
        roots.size() == 1 ? range : std::min<Int>(range, radius + radius / (stalled ? 2 : 16) + 1);
  }
}

/// A fifth of the median cost: of a quantile, not the mean, because of heavy tails.
template <class Int>
Int BlossomSolver<Int>::first_radius() const {
  constexpr std::size_t sample_size = 1000;
  std::vector<Index> sample;
  const auto cost = [this](Index arc) {
    return arcs_[arc].cost < 0 ? -arcs_[arc].cost : arcs_[arc].cost;
  };
  for (std::size_t i = 0; i < arcs_.size(); i += arcs_.size() / sample_size + 1) {
    sample.push_back(static_cast<Index>(i));
  }
  if (sample.empty()) return 1;
  sort_numbers(sample, [&](Index a, Index b) { return cost(a) < cost(b); });
  return std::min<Int>(range, cost(sample[sample.size() / 2]) / 5 + 1);
}

/// Searches from every exposed node in turn; leaves in `roots` those still exposed.
template <class Int>
void BlossomSolver<Int>::search_all(std::vector<Index>& roots, Int radius) {
  std::size_t kept = 0;
  for (const Index v : roots) {
    const Index root = outermost(v);
    if (set_of(root).label != Label::exposed) continue;
    const Outcome outcome = search(root, radius);
    if (range_exceeded_) return;
    if (outcome == Outcome::stuck) ++stuck_roots_;
    if (outcome == Outcome::limit_reached) roots[kept++] = v;
  }
  roots.resize(kept);
}

}  // namespace lpq

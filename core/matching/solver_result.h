// Reading the matching and the duals off the finished solver. Part of BlossomSolver, see solver.h.
#pragma once

#include <algorithm>

#include "base/check.h"
#include "matching/solver.h"

namespace lpq {

/// All blossoms, each after the one around it.
template <class Int>
std::vector<Index> BlossomSolver<Int>::blossoms_outside_in() const {
  std::vector<Index> order;
  for (const Set& set : sets_) {
    if (set.owner != none && is_blossom(set.owner)) order.push_back(set.owner);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index first = blossom(order[i]).base;
    Index child = first;
    do {
      if (is_blossom(child)) order.push_back(child);
      child = members_[child].next;
    } while (child != first);
  }
  return order;
}

/// Augmentations change only the mates of outermost members. Inside a blossom one child takes over
/// its mate (the one with the matched node, or the base if the blossom is exposed), and the others
/// pair up along the cycle. One walk from that node outwards settles all blossoms around it.
template <class Int>
void BlossomSolver<Int>::match_inside_blossoms() {
  std::vector<char> settled(blossoms_.size(), 0);
  for (const Index outer : blossoms_outside_in()) {
    if (settled[outer - node_count_]) continue;
    const Index mate = members_[outer].mate;
    Index child = mate == none ? outer : tail(mate);
    while (mate == none && is_blossom(child)) child = blossom(child).base;
    while (child != outer) {
      members_[child].mate = mate;
      for (Index a = members_[child].next; a != child;) {
        const Index b = members_[a].next;
        members_[a].mate = members_[a].link;
        members_[b].mate = arcs_[members_[a].link].reverse;
        a = members_[b].next;
      }
      child = members_[child].parent;
      settled[child - node_count_] = 1;
    }
  }
}

/// Repeats the filling order of the constructor to learn which arc came from which edge.
template <class Int>
void BlossomSolver<Int>::write_edges(std::span<const CostEdge> edges, std::span<const Index> new_id,
                                     Matching& result) const {
  result.mate.assign(node_count_, none);
  result.edge.assign(node_count_, none);
  result.cost = 0;
  std::vector<Index> free(row_.begin(), row_.end() - 1);
  for (Index i = 0; i < static_cast<Index>(edges.size()); ++i) {
    const CostEdge& e = edges[i];
    const Index arc = free[new_id[e.u]]++;
    ++free[new_id[e.v]];
    if (members_[new_id[e.u]].mate != arc) continue;
    LPQ_ASSERT(members_[new_id[e.v]].mate == arcs_[arc].reverse);
    result.mate[e.u] = e.v;
    result.mate[e.v] = e.u;
    result.edge[e.u] = result.edge[e.v] = i;
    result.cost += e.cost;
  }
}

/// Numbers the blossoms with z > 0 from the inside out, and takes their z out of the potentials.
template <class Int>
void BlossomSolver<Int>::write_duals(std::span<const Index> new_id, MatchingDuals& duals) const {
  const std::vector<Index> order = blossoms_outside_in();
  Index count = 0;
  for (const Index b : order) count += blossom(b).z > 0;
  duals.y.resize(node_count_);
  duals.z.resize(count);
  duals.parent.assign(node_count_ + count, none);
  std::vector<Index> id(blossoms_.size(), none);  // its own, or of the next one around with z > 0
  std::vector<std::int64_t> around(count, 0);     // sum of z from the outside to blossom id
  Index next = node_count_ + count;
  for (const Index b : order) {
    const Index outer = members_[b].parent;
    Index& own = id[b - node_count_];
    own = outer == none ? none : id[outer - node_count_];
    const std::int64_t z = blossom(b).z;
    if (z == 0) continue;
    --next;
    duals.parent[next] = own;
    duals.z[next - node_count_] = z;
    around[next - node_count_] = z + (own == none ? 0 : around[own - node_count_]);
    own = next;
  }
  for (Index v = 0; v < node_count_; ++v) {
    const Index node = new_id[v], outer = members_[node].parent;
    const Index parent = outer == none ? none : id[outer - node_count_];
    duals.parent[v] = parent;
    duals.y[v] = std::int64_t{potential(node)} -
                 (parent == none ? std::int64_t{0} : around[parent - node_count_]);
  }
}

template <class Int>
void BlossomSolver<Int>::write_result(std::span<const CostEdge> edges,
                                      std::span<const Index> new_id, bool with_duals,
                                      Matching& result) {
  match_inside_blossoms();
  write_edges(edges, new_id, result);
  result.deficiency = stuck_roots_;
  result.status = stuck_roots_ == 0 ? MatchingStatus::perfect : MatchingStatus::no_perfect;
  if (stuck_roots_ > 0) {
    std::vector<char> removed(node_count_, 0);
    for (const Index member : witness_) removed[member] = 1;
    for (Index v = 0; v < node_count_; ++v) {
      if (removed[new_id[v]]) result.witness.push_back(v);
    }
  } else if (with_duals) {
    write_duals(new_id, result.duals);
  }
}

}  // namespace lpq

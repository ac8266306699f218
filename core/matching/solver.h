// The state of the blossom algorithm and its elementary moves.
//
// Primal-dual method of Edmonds in the form of [Kolmogorov 2009]: nodes v have duals y_v, blossoms
// B duals z_B >= 0, and P(v) = y_v + sum of z_B over the blossoms around v. An edge whose ends lie
// in different outermost blossoms has slack c - P(u) - P(v) >= 0. One alternating tree is grown at
// a time from an exposed root: plus members gain what minus members lose (the clock of the search),
// until an edge to an exposed member becomes tight (augment), or the search reaches its limit and
// stops: every intermediate state is dual feasible, so a later search just continues from it.
//
// Invariants outside a search: matched edges and blossom cycles are tight; slacks and z are >= 0;
// costs are doubled, and all P within one tree have equal parity, so every event is integral.
//
// Two representations keep an event cheap however large a blossom is (nests get 10^5 deep):
//  - Outermost membership is a weighted union: every node names a set, every set its outermost
//    member and an offset common to all P within. Merging relabels all but the largest child,
//    splitting likewise [Gabow 1990].
//  - During a search offsets are stored relative to the clock, so time passes at no cost.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/index.h"
#include "matching/blossom.h"

namespace lpq {

/// Int: std::int32_t while all potentials stay small (see `range_exceeded`), else std::int64_t.
template <class Int>
class BlossomSolver {
 public:
  /// `edges` with nodes renamed: node v of the caller is node new_id[v] here.
  BlossomSolver(Index node_count, std::span<const CostEdge> edges, std::span<const Index> new_id);

  /// Runs to a maximum-cardinality matching, of minimum cost if it is perfect.
  void solve();
  /// Int was too narrow; nothing can be read off this solver.
  bool range_exceeded() const { return range_exceeded_; }

  /// Fills everything but `status`, in the caller's numbering.
  void write_result(std::span<const CostEdge> edges, std::span<const Index> new_id, bool with_duals,
                    Matching& result);

 private:
  struct Arc {  // half of an edge, leaving the node in whose list it stands
    Index to;
    Index reverse;  // the arc back
    Int cost;       // doubled
  };
  struct Node {
    Int potential;  // P without the offset of its set
    Index set;
  };
  enum class Label : std::int32_t {
    matched,  // outside the tree
    exposed,  // outside the tree and without a mate
    plus,     // even distance from the root
    minus,    // odd distance
    frozen,   // in a tree that proved to be stuck for ever (a Hungarian tree)
  };
  struct Set {  // one outermost member
    Int offset;
    Index owner;  // the member
    Label label;
  };
  struct Member {    // a node or a blossom; blossom b has id node_count + b
    Index set;       // valid while outermost
    Index mate;      // matched arc, leaving this member
    Index tree_arc;  // of a minus member: arc to its parent in the tree
    Index parent;    // the blossom around it
    Index next;      // the next child on the cycle of its parent
    Index link;      // tight arc from here to `next`
    Index visited;   // stamp of the last search for a common ancestor that met it
  };
  struct Blossom {
    Int z;                        // relative to the clock while labelled
    Index size;                   // nodes inside
    Index base;                   // a child; at creation the one nearest to the root
    std::vector<Index> boundary;  // nodes with an arc out of the blossom; empty until asked for
  };
  struct Event {
    Int key;     // clock at which it is due
    Index what;  // an arc leaving a plus node, or -1 - member to expand
  };

  enum class Outcome { augmented, limit_reached, stuck };

  // solver_rounds.h: which root to search from, and how far
  void greedy_start();
  Int first_radius() const;
  void search_all(std::vector<Index>& roots, Int radius);

  // solver_search.h: one alternating tree
  Outcome search(Index root, Int radius);
  bool next_event(Event& event);
  void handle(const Event& event);
  void push(Int key, Index what);
  void scan(Index node);
  void make_plus(Index member);
  void make_minus(Index member);
  void grow(Index arc);
  void augment(Index arc);
  void finish_search(bool stuck);

  // solver_blossoms.h: shrinking and expanding
  template <class F>
  void for_each_node(Index member, F f);
  std::span<const Index> boundary(Index member);
  Index tree_parent(Index plus_member) const;
  Index common_ancestor(Index a, Index b);
  void collect_cycle(Index arc, Index ancestor);
  void shrink(Index arc);
  void merge_sets(Index whole);
  Index new_blossom();
  void expand(Index whole);
  void split_set(Index whole);
  void collect_children(Index first);
  void reverse_cycle();
  void label_children(Index length);
  void scan_into(Index member);
  void release_blossom(Index whole);

  // solver_result.h
  std::vector<Index> blossoms_outside_in() const;
  void match_inside_blossoms();
  void write_edges(std::span<const CostEdge> edges, std::span<const Index> new_id,
                   Matching& result) const;
  void write_duals(std::span<const Index> new_id, MatchingDuals& duals) const;

  // A quarter of Int's range to the power that lets any sum of four such numbers fit.
  static constexpr Int range = static_cast<Int>(Int{1} << (8 * sizeof(Int) - 4));
  /// No two different events are equal: which of them a heap gives first is not for the library of
  /// the compiler to say.
  static bool later(const Event& a, const Event& b) {
    return a.key != b.key ? a.key > b.key : a.what > b.what;
  }

  bool is_blossom(Index member) const { return member >= node_count_; }
  Blossom& blossom(Index member) { return blossoms_[member - node_count_]; }
  const Blossom& blossom(Index member) const { return blossoms_[member - node_count_]; }
  Index size(Index member) const { return is_blossom(member) ? blossom(member).size : 1; }
  Index outermost(Index node) const { return sets_[nodes_[node].set].owner; }
  Index head(Index arc) const { return arcs_[arc].to; }
  Index tail(Index arc) const { return arcs_[arcs_[arc].reverse].to; }
  Set& set_of(Index member) { return sets_[members_[member].set]; }
  Int potential(Index node) const {
    return nodes_[node].potential + sets_[nodes_[node].set].offset;
  }
  Int slack(Index arc) const {  // relative to the clock, ends in different sets
    return arcs_[arc].cost - potential(tail(arc)) - potential(head(arc));
  }

  // The instance, as compressed rows.
  Index node_count_;
  std::vector<Index> row_;  // #nodes + 1
  std::vector<Arc> arcs_;   // 2 #edges

  std::vector<Node> nodes_;        // #nodes
  std::vector<Set> sets_;          // #nodes
  std::vector<Member> members_;    // #nodes + blossoms ever needed at once
  std::vector<Blossom> blossoms_;  // as above
  std::vector<Index> vacant_sets_;
  std::vector<Index> vacant_blossoms_;

  // One search.
  Int clock_ = 0;
  Int limit_ = 0;                // events due at or after it are not needed
  bool beyond_limit_ = false;    // some event was dropped because of it
  Index augmenting_arc_ = none;  // due at limit_
  std::vector<Event> heap_;      // due later than the clock
  std::vector<Event> due_;       // due now
  std::vector<Index> labelled_;  // members that got a label

  std::vector<Index> witness_;  // minus members of stuck trees
  Index stuck_roots_ = 0;
  bool range_exceeded_ = false;
  Index stamp_ = 0;
  std::int64_t boundary_total_ = 0;   // entries of all stored boundary lists
  std::vector<Index> cycle_, links_;  // a blossom's children round the cycle, link i leaves child i
  std::vector<Index> stack_, fresh_plus_, scratch_boundary_;
  Index single_node_ = none;
};

}  // namespace lpq

// Shrinking and expanding blossoms with weighted set merging. Part of BlossomSolver, see solver.h.
#pragma once

#include <algorithm>

#include "base/check.h"
#include "matching/solver.h"

namespace lpq {

// ---- the nodes inside a member

template <class Int>
template <class F>
void BlossomSolver<Int>::for_each_node(Index member, F f) {
  const std::size_t bottom = stack_.size();
  stack_.push_back(member);
  while (stack_.size() > bottom) {
    const Index top = stack_.back();
    stack_.pop_back();
    if (!is_blossom(top)) {
      f(top);
      continue;
    }
    const Index first = blossom(top).base;
    Index child = first;
    do {
      stack_.push_back(child);
      child = members_[child].next;
    } while (child != first);
  }
}

/// The nodes of an outermost member that have an arc out of it, the only ones a scan needs. Found
/// from the lists of the blossoms inside where those are known; they stay valid as long as the
/// blossom lives. Storage is bounded, beyond that lists are made anew each time.
template <class Int>
std::span<const Index> BlossomSolver<Int>::boundary(Index member) {
  if (!is_blossom(member)) {
    single_node_ = member;
    return {&single_node_, 1};
  }
  if (!blossom(member).boundary.empty()) return blossom(member).boundary;
  const Index set = members_[member].set;
  scratch_boundary_.clear();
  const auto take = [&](Index node) {
    for (Index arc = row_[node]; arc < row_[node + 1]; ++arc) {
      if (nodes_[arcs_[arc].to].set == set) continue;
      scratch_boundary_.push_back(node);
      return;
    }
  };
  stack_.push_back(member);
  while (!stack_.empty()) {
    const Index top = stack_.back();
    stack_.pop_back();
    if (!is_blossom(top)) {
      take(top);
    } else if (!blossom(top).boundary.empty()) {
      for (const Index node : blossom(top).boundary) take(node);
    } else {
      const Index first = blossom(top).base;
      Index child = first;
      do {
        stack_.push_back(child);
        child = members_[child].next;
      } while (child != first);
    }
  }
  const auto count = static_cast<std::int64_t>(scratch_boundary_.size());
  if (boundary_total_ + count > 2 * std::int64_t{node_count_}) return scratch_boundary_;
  boundary_total_ += count;
  blossom(member).boundary.assign(scratch_boundary_.begin(), scratch_boundary_.end());
  return blossom(member).boundary;
}

// ---- shrinking

template <class Int>
Index BlossomSolver<Int>::tree_parent(Index plus_member) const {
  const Index mate = members_[plus_member].mate;
  return mate == none ? none : outermost(head(members_[outermost(head(mate))].tree_arc));
}

/// Walks up from both plus members in turn, so the cost is that of the cycle, not of the depth.
template <class Int>
Index BlossomSolver<Int>::common_ancestor(Index a, Index b) {
  ++stamp_;
  for (;; std::swap(a, b)) {
    if (a == none) continue;
    if (members_[a].visited == stamp_) return a;
    members_[a].visited = stamp_;
    a = tree_parent(a);
  }
}

/// `cycle_` = ancestor, ..., tail, head, ... back down; `links_`[i] leaves cycle_[i] for the next.
template <class Int>
void BlossomSolver<Int>::collect_cycle(Index arc, Index ancestor) {
  cycle_.clear();
  links_.clear();
  const auto climb = [&](Index node) {
    for (Index plus = outermost(node); plus != ancestor;) {
      const Index mate = members_[plus].mate;
      const Index minus = outermost(head(mate));
      const Index up = members_[minus].tree_arc;
      cycle_.push_back(plus);
      links_.push_back(mate);
      cycle_.push_back(minus);
      links_.push_back(up);
      plus = outermost(head(up));
    }
  };
  climb(tail(arc));
  std::reverse(cycle_.begin(), cycle_.end());
  std::reverse(links_.begin(), links_.end());
  for (Index& link : links_) link = arcs_[link].reverse;
  cycle_.insert(cycle_.begin(), ancestor);
  links_.push_back(arc);
  climb(head(arc));
}

/// The arc joins two plus members: the cycle it closes becomes one plus blossom with z = 0.
template <class Int>
void BlossomSolver<Int>::shrink(Index arc) {
  const Index ancestor = common_ancestor(outermost(tail(arc)), outermost(head(arc)));
  collect_cycle(arc, ancestor);
  const Index whole = new_blossom();
  blossom(whole).z = -clock_;
  blossom(whole).base = ancestor;
  members_[whole].mate = members_[ancestor].mate;
  fresh_plus_.clear();
  for (const Index child : cycle_) {
    const bool minus = set_of(child).label == Label::minus;
    if (is_blossom(child)) blossom(child).z += minus ? -clock_ : clock_;
    if (!minus) continue;
    set_of(child).offset -= 2 * clock_;  // from the minus to the plus convention
    const auto nodes = boundary(child);
    fresh_plus_.insert(fresh_plus_.end(), nodes.begin(), nodes.end());
  }
  for (std::size_t i = 0; i < cycle_.size(); ++i) {
    Member& child = members_[cycle_[i]];
    child.next = cycle_[i + 1 < cycle_.size() ? i + 1 : 0];
    child.link = links_[i];
    child.parent = whole;
  }
  merge_sets(whole);
  set_of(whole).label = Label::plus;
  labelled_.push_back(whole);
  for (const Index node : fresh_plus_) scan(node);
}

/// The nodes of all children in `cycle_` join the set of the largest.
template <class Int>
void BlossomSolver<Int>::merge_sets(Index whole) {
  Index largest = cycle_[0], total = 0;
  for (const Index child : cycle_) {
    total += size(child);
    if (size(child) > size(largest)) largest = child;
  }
  const Index kept = members_[largest].set;
  for (const Index child : cycle_) {
    if (child == largest) continue;
    const Index old = members_[child].set;
    const Int shift = sets_[old].offset - sets_[kept].offset;
    for_each_node(child, [&](Index node) {
      nodes_[node].potential += shift;
      nodes_[node].set = kept;
    });
    sets_[old] = {0, none, Label::matched};
    vacant_sets_.push_back(old);
  }
  sets_[kept].owner = whole;
  members_[whole].set = kept;
  blossom(whole).size = total;
}

template <class Int>
Index BlossomSolver<Int>::new_blossom() {
  Index id;
  if (!vacant_blossoms_.empty()) {
    id = vacant_blossoms_.back();
    vacant_blossoms_.pop_back();
  } else {
    id = static_cast<Index>(members_.size());
    members_.push_back({});
    blossoms_.push_back({});
  }
  members_[id] = {none, none, none, none, none, none, 0};
  return id;
}

// ---- expanding

/// A minus blossom whose z has sunk to 0 is replaced by its children: the even way round the cycle
/// from where the tree enters to where it leaves joins the tree, the others become free pairs.
template <class Int>
void BlossomSolver<Int>::expand(Index whole) {
  const Index enter = members_[whole].tree_arc, leave = members_[whole].mate;
  split_set(whole);
  collect_children(outermost(tail(enter)));
  const Index last = outermost(tail(leave));
  auto length = std::find(cycle_.begin(), cycle_.end(), last) - cycle_.begin();
  if (length % 2 == 1) {
    reverse_cycle();
    length = static_cast<std::ptrdiff_t>(cycle_.size()) - length;
  }
  for (std::size_t i = 0; i < cycle_.size(); i += 2) {
    const bool on_path = static_cast<std::ptrdiff_t>(i) <= length;
    Member& child = members_[cycle_[i]];
    if (on_path) child.tree_arc = i == 0 ? enter : arcs_[links_[i - 1]].reverse;
    if (static_cast<std::ptrdiff_t>(i) == length) {
      child.mate = leave;
    } else {  // pairs (i, i+1) before the exit, (i-1, i) after it
      const std::size_t from = on_path ? i : i - 1;
      members_[cycle_[from]].mate = links_[from];
      members_[cycle_[from + 1]].mate = arcs_[links_[from]].reverse;
    }
  }
  release_blossom(whole);
  label_children(static_cast<Index>(length));
}

/// Each child gets a set of its own again; the largest keeps the common one.
template <class Int>
void BlossomSolver<Int>::split_set(Index whole) {
  const Index first = blossom(whole).base, kept = members_[whole].set;
  Index largest = first;
  for (Index child = members_[first].next; child != first; child = members_[child].next) {
    if (size(child) > size(largest)) largest = child;
  }
  Index child = first;
  do {
    members_[child].parent = none;
    if (child != largest) {
      const Index set = vacant_sets_.back();
      vacant_sets_.pop_back();
      sets_[set] = {sets_[kept].offset, child, Label::minus};
      members_[child].set = set;
      for_each_node(child, [&](Index node) { nodes_[node].set = set; });
    }
    child = members_[child].next;
  } while (child != first);
  sets_[kept].owner = largest;
  members_[largest].set = kept;
}

template <class Int>
void BlossomSolver<Int>::collect_children(Index first) {
  cycle_.clear();
  links_.clear();
  Index child = first;
  do {
    cycle_.push_back(child);
    links_.push_back(members_[child].link);
    child = members_[child].next;
  } while (child != first);
}

/// The other way round, from the same start.
template <class Int>
void BlossomSolver<Int>::reverse_cycle() {
  std::reverse(cycle_.begin() + 1, cycle_.end());
  std::reverse(links_.begin(), links_.end());
  for (Index& link : links_) link = arcs_[link].reverse;
}

/// Labels the children of an expanded minus blossom: minus, plus, ..., minus up to position
/// `length` of the cycle, free beyond. Scans come last, when all labels stand.
template <class Int>
void BlossomSolver<Int>::label_children(Index length) {
  const auto count = static_cast<Index>(cycle_.size());
  for (Index i = 0; i < count; ++i) {
    const Index child = cycle_[i];
    Set& set = set_of(child);
    if (i > length) {
      set.label = Label::matched;
      set.offset -= clock_;
    } else if (i % 2 == 1) {
      set.label = Label::plus;
      set.offset -= 2 * clock_;
      if (is_blossom(child)) blossom(child).z -= clock_;
      labelled_.push_back(child);
    } else {  // keeps the minus convention of the whole
      set.label = Label::minus;
      labelled_.push_back(child);
      if (!is_blossom(child)) continue;
      blossom(child).z += clock_;
      push(blossom(child).z, -1 - child);
    }
  }
  for (Index i = 1; i < count; ++i) {
    const Index child = cycle_[i];
    if (i > length) {
      scan_into(child);
    } else if (i % 2 == 1) {
      for (const Index node : boundary(child)) scan(node);
    }
  }
}

/// A member became free in the middle of a search: queue the arcs into it from plus nodes.
template <class Int>
void BlossomSolver<Int>::scan_into(Index member) {
  const Index own_set = members_[member].set;
  for (const Index node : boundary(member)) {
    const Int own = nodes_[node].potential + sets_[own_set].offset;
    for (Index arc = row_[node]; arc < row_[node + 1]; ++arc) {
      const Index neighbour = arcs_[arc].to;
      if (sets_[nodes_[neighbour].set].label != Label::plus) continue;
      push(arcs_[arc].cost - own - potential(neighbour), arcs_[arc].reverse);
    }
  }
}

template <class Int>
void BlossomSolver<Int>::release_blossom(Index whole) {
  boundary_total_ -= static_cast<std::int64_t>(blossom(whole).boundary.size());
  blossom(whole) = {};
  vacant_blossoms_.push_back(whole);
}

}  // namespace lpq

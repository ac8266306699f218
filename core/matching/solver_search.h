// One alternating tree: grow, augment, and the event queue. Part of BlossomSolver, see solver.h.
#pragma once

#include <algorithm>

#include "base/check.h"
#include "matching/solver.h"

namespace lpq {

/// Grows a tree from the exposed member `root` until it is augmented, until the clock has advanced
/// by `radius` (the duals gained stay), or until nothing at all can happen any more.
template <class Int>
auto BlossomSolver<Int>::search(Index root, Int radius) -> Outcome {
  clock_ = 0;
  limit_ = radius;
  beyond_limit_ = false;
  augmenting_arc_ = none;
  heap_.clear();
  due_.clear();
  labelled_.clear();
  make_plus(root);
  for (Event event; next_event(event);) handle(event);
  if (augmenting_arc_ != none) {
    clock_ = limit_;
    augment(augmenting_arc_);
    finish_search(false);
    return Outcome::augmented;
  }
  if (beyond_limit_) {
    clock_ = limit_;
    finish_search(false);
    return Outcome::limit_reached;
  }
  finish_search(true);
  return Outcome::stuck;
}

/// An exposed neighbour lowers `limit_` to the moment its edge gets tight, so later events, which
/// the augmentation pre-empts, never enter the heap.
template <class Int>
void BlossomSolver<Int>::push(Int key, Index what) {
  if (key >= limit_) {
    beyond_limit_ = true;
  } else if (key == clock_) {
    due_.push_back({key, what});
  } else {
    heap_.push_back({key, what});
    std::push_heap(heap_.begin(), heap_.end(), later);
  }
}

template <class Int>
bool BlossomSolver<Int>::next_event(Event& event) {
  if (augmenting_arc_ != none && limit_ == clock_) return false;
  if (!due_.empty()) {
    event = due_.back();
    due_.pop_back();
    return true;
  }
  if (heap_.empty()) return false;
  event = heap_.front();
  if (event.key >= limit_) {  // the limit was lowered after it was pushed
    beyond_limit_ = true;
    return false;
  }
  std::pop_heap(heap_.begin(), heap_.end(), later);
  heap_.pop_back();
  return true;
}

/// Events are not withdrawn when they lose their meaning; each is checked when it comes up. An
/// event that is still true has its key equal to the present slack.
template <class Int>
void BlossomSolver<Int>::handle(const Event& event) {
  if (event.what < 0) {
    const Index member = -1 - event.what;
    const Set& set = set_of(member);
    if (set.owner != member || set.label != Label::minus || blossom(member).z != event.key) return;
    clock_ = event.key;
    expand(member);
    return;
  }
  const Index arc = event.what;
  const Set& from = sets_[nodes_[tail(arc)].set];
  const Set& to = sets_[nodes_[head(arc)].set];
  if (&from == &to || from.label != Label::plus) return;
  if (to.label == Label::matched && slack(arc) == event.key) {
    clock_ = event.key;
    grow(arc);
  } else if (to.label == Label::plus && slack(arc) / 2 == event.key) {
    clock_ = event.key;
    shrink(arc);
  }
}

/// Queues what the arcs of a plus node will cause.
template <class Int>
void BlossomSolver<Int>::scan(Index node) {
  const Index own_set = nodes_[node].set;
  const Int own = nodes_[node].potential + sets_[own_set].offset;
  if (own + clock_ > range || own + clock_ < -range) range_exceeded_ = true;
  for (Index arc = row_[node]; arc < row_[node + 1]; ++arc) {
    const Node& neighbour = nodes_[arcs_[arc].to];
    if (neighbour.set == own_set) continue;
    const Set& set = sets_[neighbour.set];
    const Int due = arcs_[arc].cost - own - neighbour.potential - set.offset;
    if (set.label == Label::matched) {
      push(due, arc);
    } else if (set.label == Label::plus) {
      push(due / 2, arc);
    } else if (set.label == Label::exposed) {
      if (due < limit_) {
        limit_ = due;
        augmenting_arc_ = arc;
      } else if (augmenting_arc_ == none) {
        beyond_limit_ = true;
      }
    }
  }
}

template <class Int>
void BlossomSolver<Int>::make_plus(Index member) {
  Set& set = set_of(member);
  set.label = Label::plus;
  set.offset -= clock_;
  labelled_.push_back(member);
  if (is_blossom(member)) blossom(member).z -= clock_;
  for (const Index node : boundary(member)) scan(node);
}

template <class Int>
void BlossomSolver<Int>::make_minus(Index member) {
  Set& set = set_of(member);
  set.label = Label::minus;
  set.offset += clock_;
  labelled_.push_back(member);
  if (!is_blossom(member)) return;
  blossom(member).z += clock_;
  push(blossom(member).z, -1 - member);
}

/// The arc reached a matched member: it joins the tree as minus, its mate as plus.
template <class Int>
void BlossomSolver<Int>::grow(Index arc) {
  const Index reached = outermost(head(arc));
  members_[reached].tree_arc = arcs_[arc].reverse;
  make_minus(reached);
  make_plus(outermost(head(members_[reached].mate)));
}

/// Swaps matched and unmatched along the path from the head of `arc` to the root.
template <class Int>
void BlossomSolver<Int>::augment(Index arc) {
  const Index reached = outermost(head(arc));
  members_[reached].mate = arcs_[arc].reverse;
  set_of(reached).label = Label::matched;
  for (;;) {
    const Index plus = outermost(tail(arc));
    const Index old = members_[plus].mate;
    members_[plus].mate = arc;
    if (old == none) return;
    const Index minus = outermost(head(old));
    const Index up = members_[minus].tree_arc;
    members_[minus].mate = up;
    arc = arcs_[up].reverse;
  }
}

/// Takes the clock out of the offsets and the labels away. A stuck tree is put aside: its plus
/// members touch nothing but its minus members, so no augmentation will ever pass through it.
template <class Int>
void BlossomSolver<Int>::finish_search(bool stuck) {
  for (const Index member : labelled_) {
    Set& set = set_of(member);
    if (set.owner != member || (set.label != Label::plus && set.label != Label::minus)) continue;
    const bool minus = set.label == Label::minus;
    set.offset += minus ? -clock_ : clock_;
    if (is_blossom(member)) blossom(member).z += minus ? -clock_ : clock_;
    if (stuck) {
      if (minus) witness_.push_back(member);
      set.label = Label::frozen;
    } else {
      set.label = members_[member].mate == none ? Label::exposed : Label::matched;
    }
  }
}

}  // namespace lpq

// Breadth-first search from a vertex for the irregular vertices near it, with the way back.
#pragma once

#include "cleanup/ideal_valence.h"

namespace lpq {

class Search {
 public:
  Search(const QuadTopology& mesh, const IdealValence& ideal) : mesh_(mesh), ideal_(ideal) {}

  void start(Index v) {
    for (const Index u : seen_) parent_[u] = unseen;
    parent_.resize(mesh_.vertex_count(), unseen);
    seen_.assign(1, v);
    parent_[v] = none;
    next_ = 0;
  }

  /// The next irregular vertex, none when there is none among the first `most` vertices.
  Index next(std::size_t most) {
    while (next_ < seen_.size() && next_ < most) {
      const Index v = seen_[next_++];
      expand(v);
      if (next_ > 1 && !ideal_.is_regular(mesh_, v)) return v;
    }
    return none;
  }

  /// One step back towards the start, none there.
  Index parent(Index v) const { return parent_[v]; }

 private:
  static constexpr Index unseen = -2;

  void expand(Index v) {
    if (mesh_.is_fixed(v) && ideal_.is_divided(v)) return;  // walls part its neighbours
    for (const Index f : mesh_.faces_of(v)) {
      const Face& face = mesh_.face(f);
      const Index k = corner_of(face, v);
      for (const Index w : {next_corner(face, k), prev_corner(face, k)}) {
        if (parent_[w] != unseen) continue;
        parent_[w] = v;
        seen_.push_back(w);
      }
    }
  }

  const QuadTopology& mesh_;
  const IdealValence& ideal_;
  std::vector<Index> parent_;  // #V
  std::vector<Index> seen_;
  std::size_t next_ = 0;
};

}  // namespace lpq

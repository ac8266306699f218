// See springs.h.
#include "grids/springs.h"

#include <utility>

namespace lpq {

Springs::Springs(std::vector<Index> body, std::vector<Vec2> place, Index bodies)
    : body_(std::move(body)),
      place_(std::move(place)),
      load_(2 * static_cast<std::size_t>(bodies), 0) {}

void Springs::add(Index v, Index w, Vec2 jump) {
  pull(v, w, jump);
  pull(w, v, -jump);
}

void Springs::pull(Index v, Index w, Vec2 jump) {
  const Index b = body_[v], c = body_[w];
  if (b == none || b == c) return;
  entries_.push_back({b, b, 1});
  if (c != none && c < b) entries_.push_back({b, c, -1});
  const Vec2 d = place_[w] + jump - place_[v];
  load_[b] += d.x;
  load_[load_.size() / 2 + b] += d.y;
}

std::vector<Vec2> Springs::rest() const {
  const std::size_t bodies = load_.size() / 2;
  std::vector<double> x;
  const auto n = static_cast<Index>(bodies);
  if (n == 0 || solve_spd(n, entries_, load_, 2, x) != SparseStatus::ok) return {};
  std::vector<Vec2> places(bodies);
  for (std::size_t b = 0; b < bodies; ++b) places[b] = {x[b], x[bodies + b]};
  return places;
}

}  // namespace lpq

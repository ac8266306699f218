// See loop_turns.h.
#include "shell/grids/loop_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cleanup/ideal_valence.h"
#include "mesh/ideal_quads.h"
#include "numerics/elementary.h"
#include "shell/grids/lattice.h"

namespace lpq {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_edges = 4000;
// Quarter turns that a border may wander to either side of where it started.
constexpr Index most_turns = 8;
// Edges by which a way that closes may be off the cheapest one.
constexpr Index widest_reach = 8;
// Of an edge that is off by a quarter turn; a node with one quad too many or too few is 1.
constexpr double price_of_angle = 0.2;
// Of a corner of a quad that would be flat.
constexpr double flat_corner = 170 * pi / 180, price_of_flat = 6;

/// A node of the border.
struct Turning {
  std::array<double, 3> price;  // of a turn to the right, none, one to the left
  double turn = 0;              // quarter turns to the left in the plane
};

/// From the node `first` on.
std::vector<Turning> turnings_of(std::span<const Vec2> points, std::size_t first) {
  const std::size_t n = points.size();
  std::vector<double> angle(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = first + k;
    angle[k] = sector_angle(points[at % n], points[(at + 1) % n], points[(at + n - 1) % n]);
  }
  std::vector<Turning> turnings(n);
  for (std::size_t k = 0; k < n; ++k) {
    for (Index quads = 1; quads <= 3; ++quads) {
      const double off = quads - fitting_quads(angle[k]);
      turnings[k].price[static_cast<std::size_t>(3 - quads)] =
          off * off + (angle[k] < flat_corner * quads ? 0 : price_of_flat);
    }
    turnings[k].turn = (pi - angle[k]) / (pi / 2);
  }
  return turnings;
}

/// The cheapest way round: dynamic programming over the edges. A state is the quarter turns made so
/// far and, where the way has to close, how far it is from a line to both sides, up to `reach`.
class WayRound {
 public:
  /// The way begins in direction 0 with the edge from the first node; in the plane that edge points
  /// `off` quarter turns further left. `turns`: quarter turns in all.
  WayRound(std::vector<Turning> nodes, double off, Index turns)
      : nodes_(std::move(nodes)), off_(off), turns_(turns) {}

  /// The cheapest of all ways; or, along `line`, the cheapest that closes. Empty if there is none.
  std::vector<Index> run(std::span<const Index> line) {
    line_ = line;
    reach_ = line.empty() ? 0 : widest_reach;
    side_ = 2 * reach_ + 1;
    came_.assign(nodes_.size() * state_count(), 0);
    price_.assign(state_count(), infinity);
    price_[state(0, {reach_, reach_})] = 0;
    double heading = off_;
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
      heading += nodes_[k].turn;
      pass(k, heading);
    }
    return trace();
  }

 private:
  std::size_t state_count() const {
    return static_cast<std::size_t>((2 * most_turns + 1) * side_ * side_);
  }
  std::size_t state(Index direction, LatticePlace off) const {
    return static_cast<std::size_t>(((direction + most_turns) * side_ + off.x) * side_ + off.y);
  }
  bool is_near(LatticePlace off) const {
    return off.x >= 0 && off.y >= 0 && off.x < side_ && off.y < side_;
  }
  /// How much further off the line one is after edge k in this direction.
  LatticePlace drift(std::size_t k, Index direction) const {
    return line_.empty() ? LatticePlace{} : lattice_step(direction) - lattice_step(line_[k]);
  }

  /// From edge k - 1 over node k to edge k, which has this heading in the plane.
  void pass(std::size_t k, double heading) {
    next_.assign(state_count(), infinity);
    for (Index from = -most_turns; from <= most_turns; ++from)
      for (Index turn = -1; turn <= 1; ++turn) {
        const Index to = from + turn;
        if (to < -most_turns || to > most_turns) continue;
        const double angle = std::min(1.0, (heading - to) * (heading - to));
        go(k, from, turn,
           nodes_[k].price[static_cast<std::size_t>(turn + 1)] + price_of_angle * angle);
      }
    price_.swap(next_);
  }

  void go(std::size_t k, Index from, Index turn, double price) {
    const LatticePlace by = drift(k, from + turn);
    for (Index x = 0; x < side_; ++x)
      for (Index y = 0; y < side_; ++y) {
        const LatticePlace off = LatticePlace{x, y} + by;
        if (!is_near(off)) continue;
        const double sum = price_[state(from, {x, y})] + price;
        const std::size_t s = state(from + turn, off);
        if (!(sum < next_[s])) continue;
        next_[s] = sum;
        came_[k * state_count() + s] = static_cast<signed char>(turn);
      }
  }

  std::vector<Index> trace() const {
    // A way that closes is as far off the line at its end as the line is off its start.
    LatticePlace off{reach_, reach_};
    for (const Index d : line_) off = off - lattice_step(d);
    if (!is_near(off)) return {};
    Index direction = none;
    double least = infinity;
    for (Index turn = -1; turn <= 1; ++turn) {
      const double sum =
          price_[state(turns_ - turn, off)] + nodes_[0].price[static_cast<std::size_t>(turn + 1)];
      if (!(sum < least)) continue;
      least = sum;
      direction = turns_ - turn;
    }
    if (least == infinity) return {};
    std::vector<Index> way(nodes_.size());
    for (std::size_t k = way.size() - 1; k > 0; --k) {
      way[k] = direction;
      const Index turn = came_[k * state_count() + state(direction, off)];
      off = off - drift(k, direction);
      direction -= turn;
    }
    way[0] = direction;
    return way;
  }

  std::vector<Turning> nodes_;
  double off_;
  Index turns_;
  std::span<const Index> line_;
  Index reach_ = 0, side_ = 1;
  std::vector<double> price_, next_;  // of states at this edge and the next
  std::vector<signed char> came_;     // #points #states  the turn that led there
};

bool closes(std::span<const Index> way) {
  LatticePlace place;
  for (const Index d : way) place = place + lattice_step(d);
  return place == LatticePlace{};
}

/// The edge that is nearest to the lattice's directions, where the way begins.
struct Start {
  std::size_t edge = 0;
  Index direction = 0;
  double off = infinity;  // quarter turns to the left
};

Start start_of(std::span<const Vec2> points, double axis) {
  Start start;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 edge = points[(k + 1) % points.size()] - points[k];
    const double turned = (arc_tangent(edge.y, edge.x) - axis) / (pi / 2);
    const double nearest = std::floor(turned + 0.5);
    if (std::fabs(turned - nearest) < std::fabs(start.off))
      start = {k, static_cast<Index>(nearest), turned - nearest};
  }
  return start;
}

}  // namespace

std::vector<Index> loop_turns(std::span<const Vec2> points, double axis) {
  const std::size_t n = points.size();
  if (n > most_edges) return {};
  const Start start = start_of(points, axis);
  std::vector<Turning> nodes = turnings_of(points, start.edge);
  double turns = 0;
  for (const Turning& node : nodes) turns += node.turn;
  WayRound way(std::move(nodes), start.off, turns > 0 ? 4 : -4);
  std::vector<Index> found = way.run({});
  if (!closes(found)) found = way.run(std::vector<Index>(found));
  if (found.empty()) return {};
  std::vector<Index> directions(n);
  for (std::size_t k = 0; k < n; ++k) directions[(start.edge + k) % n] = start.direction + found[k];
  return directions;
}

}  // namespace lpq

// See loop_turns.h.
#include "grids/loop_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/function_ref.h"
#include "cleanup/ideal_valence.h"
#include "grids/lattice.h"
#include "mesh/ideal_quads.h"
#include "numerics/elementary.h"

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

LatticePlace sum_of(std::span<const Index> directions) {
  LatticePlace sum;
  for (const Index d : directions) sum = sum + lattice_step(d);
  return sum;
}

/// By quarter turns to the left.
LatticePlace turned_left(LatticePlace p, Index quarters) {
  for (Index k = quarters & 3; k > 0; --k) p = {-p.y, p.x};
  return p;
}

/// A node of the border.
struct Turning {
  std::array<double, 3> price;  // of a turn to the right, none, one to the left
  double turn = 0;              // quarter turns to the left in the plane
};

/// A border in the plane; it comes back `period` further.
struct Border {
  std::span<const Vec2> points;
  Vec2 period;

  std::size_t size() const { return points.size(); }
  /// The way along edge k.
  Vec2 edge(std::size_t k) const {
    const bool last = k + 1 == size();
    return points[last ? 0 : k + 1] + (last ? period : Vec2{}) - points[k];
  }
};

/// From the node `first` on.
std::vector<Turning> turnings_of(const Border& border, std::size_t first) {
  const std::size_t n = border.size();
  std::vector<double> angle(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = first + k;
    angle[k] = sector_angle({}, border.edge(at % n), -border.edge((at + n - 1) % n));
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

  /// The cheapest of all ways; or, along `line`, the cheapest that ends `end` from its start. Empty
  /// if there is none.
  std::vector<Index> run(std::span<const Index> line, LatticePlace end) {
    line_ = line;
    end_ = end;
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
    LatticePlace off{reach_, reach_};
    if (!line_.empty()) off = off + end_ - sum_of(line_);
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
  LatticePlace end_;
  Index reach_ = 0, side_ = 1;
  std::vector<double> price_, next_;  // of states at this edge and the next
  std::vector<signed char> came_;     // #points #states  the turn that led there
};

/// Directions are counted from the edge where the way begins, the one that is nearest to the
/// lattice's.
struct Start {
  std::size_t edge = 0;
  Index direction = 0;
  double off = infinity;  // quarter turns to the left
};

Start start_of(const Border& border, double axis) {
  Start start;
  for (std::size_t k = 0; k < border.size(); ++k) {
    const Vec2 edge = border.edge(k);
    const double turned = (arc_tangent(edge.y, edge.x) - axis) / (pi / 2);
    const double nearest = std::floor(turned + 0.5);
    if (std::fabs(turned - nearest) < std::fabs(start.off))
      start = {k, static_cast<Index>(nearest), turned - nearest};
  }
  return start;
}

/// Where a line ends, seen from its start; and what is wanted there instead.
using End = FunctionRef<LatticePlace(LatticePlace)>;

std::vector<Index> turns_of(const Border& border, double axis, End wanted) {
  const std::size_t n = border.size();
  if (n > most_edges) return {};
  const Start start = start_of(border, axis);
  std::vector<Turning> nodes = turnings_of(border, start.edge);
  double turns = 0;
  for (const Turning& node : nodes) turns += node.turn;
  const auto rounds = static_cast<Index>(std::floor(turns / 4 + 0.5));
  if (std::abs(rounds) > 1) return {};
  WayRound way(std::move(nodes), start.off, 4 * rounds);
  std::vector<Index> found = way.run({}, {});
  const LatticePlace end = sum_of(found);
  const LatticePlace better =
      turned_left(wanted(turned_left(end, start.direction)), -start.direction);
  if (!(better == end)) found = way.run(std::vector<Index>(found), better);
  if (found.empty()) return {};
  std::vector<Index> directions(n);
  for (std::size_t k = 0; k < n; ++k) directions[(start.edge + k) % n] = start.direction + found[k];
  return directions;
}

}  // namespace

std::vector<Index> loop_turns(std::span<const Vec2> points, double axis) {
  return turns_of({points, {}}, axis, [](LatticePlace) { return LatticePlace{}; });
}

std::vector<Index> open_turns(std::span<const Vec2> points, double axis) {
  return turns_of({points, {}}, axis, [](LatticePlace end) { return end; });
}

std::vector<Index> line_turns(std::span<const Vec2> points, Vec2 period,
                              std::optional<Index> rows) {
  return turns_of({points, period}, 0, [rows](LatticePlace end) {
    // The columns and rows that so many edges pass are both odd or both even.
    return LatticePlace{0, rows.value_or(end.y - std::abs(end.x) % 2)};
  });
}

}  // namespace lpq

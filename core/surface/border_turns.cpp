// See border_turns.h.
#include "surface/border_turns.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"

namespace lpq {
namespace {

// A vertex turns the border if it turns by so much, or if the border does within so many mesh sizes
// to both sides; radians. Regular polygons meet both to the last digit: rounding must not decide.
constexpr double rounding = 1e-9;
constexpr double sharp_turn = 25 * pi / 180;
constexpr double tight_turn = (60 - rounding) * pi / 180, tight_reach = 1.5 + rounding;
// Turns one way at both ends of an edge, or nearer to each other than so many mesh sizes, are one
// bend, and a bend is a number of right angles: the long way round coarse polygons is rounded once.
// The edge behind a turn is no gap even where its end does not turn; to count it gains nothing.
constexpr double bend_gap = 1;
constexpr double little = 0.5;  // mesh sizes; a shorter piece of a curve is no side

// Radians by which a border may turn more or less than by right angles in all.
constexpr double most_unsettled = 10 * pi / 180;
// Right angles that are left out by what a way counts as: it may count as one more, or must not.
constexpr double least_rest = 0.8, most_left = 0.3;

Index right_angles(double turn) {
  const double quarters = turn / (0.5 * pi);
  return static_cast<Index>(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
}

/// Lengths too short for a side of their own go to the main direction.
void drop_little_pieces(BorderSide& side) {
  const Index main = side.main_direction();
  for (Index k = 0; k < right_angles_round; ++k) {
    if (k == main || side.length[k] >= little) continue;
    side.length[main] += side.length[k];
    side.length[k] = 0;
  }
}

/// A piece of a border between two places where it starts or ends to turn: a bend, or a way that is
/// straight or nearly so beside the mesh.
struct BorderPiece {
  std::size_t end = 0;     // behind its last step
  double turn = 0;         // radians, of the steps that count
  Index right_angles = 0;  // that it counts as
  bool bend = false;

  /// What is left out by counting so, in right angles.
  double rest() const { return turn / (0.5 * pi) - right_angles; }
};

bool is_sharp(const BorderStep& step) { return std::abs(step.turn) >= sharp_turn; }

/// Sums along three rounds of a border, to look from every step of the second to both sides.
class TurnSums {
 public:
  explicit TurnSums(const std::vector<BorderStep>& steps)
      : count_(steps.size()), behind_sharp_(3 * count_, 0), sharp_(3 * count_, 3 * count_) {
    double along = 0, turned = 0;
    turned_.push_back(0);
    for (std::size_t i = 0; i < 3 * count_; ++i) {
      const BorderStep& step = steps[i % count_];
      along_.push_back(along += step.length);
      turned_.push_back(turned += step.turn);
    }
    for (std::size_t i = 1; i < 3 * count_; ++i) {
      const std::size_t back = 3 * count_ - i;
      behind_sharp_[i] = is_sharp(steps[(i - 1) % count_]) ? i : behind_sharp_[i - 1];
      sharp_[back - 1] = is_sharp(steps[back % count_]) ? back : sharp_[back];
    }
  }

  /// The turns within `reach` of the end of step k, half a round at most, that lie before the next
  /// sharp one to either side.
  double around(std::size_t k, double reach) const {
    k += count_;
    const auto here = along_.begin() + k, round = here + count_;
    const auto first = std::lower_bound(here - count_ + 1, here, *here - reach);
    const auto end = std::upper_bound(here, round, *here + reach);
    const auto from = std::max<std::size_t>(first - along_.begin(), behind_sharp_[k]);
    const auto to = std::min<std::size_t>(end - along_.begin(), sharp_[k]);
    return turned_[to] - turned_[from];
  }

 private:
  std::size_t count_;
  std::vector<double> along_, turned_;             // up to the end of each step; before each step
  std::vector<std::size_t> behind_sharp_, sharp_;  // behind the last sharp step before; the next
};

/// How a border turns, from its steps.
class Turns {
 public:
  explicit Turns(std::vector<BorderStep> steps) : steps_(std::move(steps)) {
    for (const BorderStep& step : steps_) round_ += step.length;
    find_ways();
    begin_on_straight();
    divide();
    settle();
  }

  FaceBorder run() {
    bool starts_curve = true;
    Index heading = 0;
    std::size_t k = 0;
    for (const BorderPiece& piece : pieces_) {
      const double scale = piece.turn != 0 ? 0.5 * pi * piece.right_angles / piece.turn : 0;
      double turned = 0;
      for (; k < piece.end; ++k) {
        const BorderStep& step = steps_[k];
        if (starts_curve) border_.sides.push_back({step.curve, {}});
        const Index now = heading + right_angles(turned * scale);
        border_.sides.back().length[direction_after(now)] += step.length;
        border_.run[direction_after(now)] += step.edge;
        border_.length += length(step.edge);
        starts_curve = step.ends_curve;
        if (counts(piece, k)) turned += step.turn;
      }
      heading += piece.right_angles;
    }
    border_.turns = heading;
    if (is_round()) make_round();
    if (!starts_curve) join_ends();
    for (BorderSide& side : border_.sides) drop_little_pieces(side);
    return std::move(border_);
  }

 private:
  bool is_round() const {
    const auto is_corner = [](const BorderStep& step) { return std::abs(step.turn) >= tight_turn; };
    const auto other_way = [this](int way) { return way == -way_.front(); };
    return straight_ <= bend_gap && std::none_of(steps_.begin(), steps_.end(), is_corner) &&
           std::none_of(way_.begin(), way_.end(), other_way);
  }

  void make_round() {
    border_.round = true;
    border_.turns = 0;
    for (BorderSide& side : border_.sides) side.length = {side.whole(), 0, 0, 0};
  }

  /// The longest edge with a straight way behind it comes first.
  void begin_on_straight() {
    std::size_t start = 0;
    double longest = 0, straight = 0;
    for (std::size_t k = 0; k < 2 * steps_.size(); ++k) {
      const std::size_t at = k % steps_.size();
      straight += steps_[at].length;
      if (straight > longest) {
        longest = straight;
        start = at;
      }
      if (way_[at] != 0) straight = 0;
    }
    std::rotate(steps_.begin(), steps_.begin() + start, steps_.end());
    std::rotate(way_.begin(), way_.begin() + start, way_.end());
    straight_ = longest;
  }

  /// The turn at the end of step k is part of what the piece turns by.
  bool counts(const BorderPiece& piece, std::size_t k) const { return !piece.bend || way_[k] != 0; }

  /// A bend turns at the ends of its steps; the last step before it belongs to it.
  void divide() {
    for (std::size_t k = 0; k < steps_.size();) {
      BorderPiece piece = way_[k] != 0 ? bend_from(k) : straight_from(k);
      for (; k < piece.end; ++k)
        if (counts(piece, k)) piece.turn += steps_[k].turn;
      if (piece.bend) piece.right_angles = right_angles(piece.turn);
      pieces_.push_back(piece);
    }
  }

  BorderPiece straight_from(std::size_t k) const {
    while (k < steps_.size() && way_[k] == 0) ++k;
    return {.end = k};
  }

  /// All that turns one way from step k on.
  BorderPiece bend_from(std::size_t k) const {
    BorderPiece bend{.bend = true};
    double gap = 0;
    const int way = way_[k];
    for (bend.end = k; k < steps_.size(); ++k) {
      gap += k > bend.end ? steps_[k].length : 0;
      if (way_[k] == -way || gap > bend_gap) break;
      if (way_[k] == 0) continue;
      gap = 0;
      bend.end = k + 1;
    }
    return bend;
  }

  /// A border turns round a flat face by four right angles in all. Rounding bends one by one may
  /// have made other numbers of them, but where a way that is straight beside the mesh turns by a
  /// right angle from end to end; it counts then. Not if something else is far from what it counts
  /// as: which of several to round the other way would be arbitrary.
  void settle() {
    double all = 0;
    Index turns = 0;
    for (const BorderStep& step : steps_) all += step.turn;
    for (const BorderPiece& piece : pieces_) turns += piece.right_angles;
    const Index wanted = right_angles(all);
    const bool bends = std::any_of(way_.begin(), way_.end(), [](int way) { return way != 0; });
    if (!bends || turns == wanted || std::abs(all - 0.5 * pi * wanted) > most_unsettled) return;
    const int way = turns < wanted ? 1 : -1;
    std::vector<BorderPiece> settled = pieces_;
    for (; turns != wanted; turns += way) {
      BorderPiece& piece = settled[most_rest(settled, way)];
      if (way * piece.rest() < least_rest) return;
      piece.right_angles += way;
    }
    if (way * settled[most_rest(settled, way)].rest() <= most_left) pieces_ = std::move(settled);
  }

  static std::size_t most_rest(const std::vector<BorderPiece>& pieces, int way) {
    std::size_t most = 0;
    for (std::size_t k = 1; k < pieces.size(); ++k)
      if (way * pieces[k].rest() > way * pieces[most].rest()) most = k;
    return most;
  }

  /// The border began on the way along a curve; the end goes on in the direction of the start.
  void join_ends() {
    if (border_.sides.size() == 1) return;
    const BorderSide last = border_.sides.back();
    border_.sides.pop_back();
    for (Index k = 0; k < right_angles_round; ++k)
      border_.sides.front().length[direction_after(k - border_.turns)] += last.length[k];
  }

  /// Which way the border turns at the end of each step: 1, -1, or 0 if it does not.
  void find_ways() {
    const TurnSums sums(steps_);
    const double reach = std::min(tight_reach, 0.5 * round_);
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const bool sharp = is_sharp(steps_[k]);
      const double turn = sharp ? steps_[k].turn : sums.around(k, reach);
      const bool turns = sharp || std::abs(turn) >= tight_turn;
      way_.push_back(!turns ? 0 : turn > 0 ? 1 : -1);
    }
  }

  std::vector<BorderStep> steps_;
  std::vector<int> way_;  // #steps
  std::vector<BorderPiece> pieces_;
  double round_ = 0;     // length in all
  double straight_ = 0;  // the longest straight way
  FaceBorder border_;
};

}  // namespace

FaceBorder border_of(std::vector<BorderStep> steps) { return Turns(std::move(steps)).run(); }

}  // namespace lpq

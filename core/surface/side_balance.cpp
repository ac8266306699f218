#include "surface/side_balance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr Index right_angles_round = 4;

// A vertex turns the border if it turns by so much, or if the border does within so many mesh sizes
// to both sides; radians.
constexpr double sharp_turn = 25 * pi / 180;
constexpr double tight_turn = 60 * pi / 180, tight_reach = 1.5;
// Turns one way that are nearer to each other than so many mesh sizes are one bend, and a bend is a
// number of right angles.
constexpr double bend_gap = 1;
constexpr double little = 0.5;  // mesh sizes; a shorter piece of a curve is no side

Index right_angles(double turn) {
  const double quarters = turn / (0.5 * pi);
  return static_cast<Index>(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
}

Index direction(Index right_angles) {
  return (right_angles % right_angles_round + right_angles_round) % right_angles_round;
}

/// Part of a border on one curve: its length, in mesh sizes, in each of the four directions.
/// Direction 0 is that in which the border began.
struct Side {
  Index curve = none;
  std::array<double, right_angles_round> length{};

  Index main_direction() const {
    return static_cast<Index>(std::max_element(length.begin(), length.end()) - length.begin());
  }
  bool is_straight() const { return length[main_direction()] == whole(); }
  double whole() const { return std::accumulate(length.begin(), length.end(), 0.0); }

  void drop_little_pieces() {
    const Index main = main_direction();
    for (Index k = 0; k < right_angles_round; ++k) {
      if (k == main || length[k] >= little) continue;
      length[main] += length[k];
      length[k] = 0;
    }
  }
};

/// A length in edges.
Index rounded(double length) { return static_cast<Index>(std::floor(length + 0.5)); }

struct Border {
  Index face = none, turns = 0;  // in all
  std::vector<Side> sides;
  bool round = false;  // one bend all the way: does not count as turning
};

/// An edge on a border: its length in mesh sizes, and by how much the border turns at its end.
struct BorderStep {
  Index curve = none;
  double length = 0, turn = 0;
  bool ends_curve = false;
};

/// How a border turns, from its steps.
class Turns {
 public:
  explicit Turns(std::vector<BorderStep> steps) : steps_(std::move(steps)) {
    for (const BorderStep& step : steps_) round_ += step.length;
    for (std::size_t k = 0; k < steps_.size(); ++k) way_.push_back(way_at(k));
    begin_on_straight();
  }

  Border run() {
    bool starts_curve = true;
    Index heading = 0;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const BorderStep& step = steps_[k];
      if (starts_curve) border_.sides.push_back({step.curve, {}});
      border_.sides.back().length[direction(heading)] += step.length;
      starts_curve = step.ends_curve;
      if (way_[k] != 0) heading = turn_at(k, heading);
    }
    border_.turns = heading;
    if (is_round()) make_round();
    if (!starts_curve) join_ends();
    for (Side& side : border_.sides) side.drop_little_pieces();
    return std::move(border_);
  }

 private:
  static bool is_sharp(const BorderStep& step) { return std::abs(step.turn) >= sharp_turn; }

  bool is_round() const {
    const auto is_corner = [](const BorderStep& step) { return std::abs(step.turn) >= tight_turn; };
    const auto other_way = [this](int way) { return way == -way_.back(); };
    return straight_ <= bend_gap && std::none_of(steps_.begin(), steps_.end(), is_corner) &&
           std::none_of(way_.begin(), way_.end(), other_way);
  }

  void make_round() {
    border_.round = true;
    border_.turns = 0;
    for (Side& side : border_.sides) side.length = {side.whole(), 0, 0, 0};
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

  /// The direction behind step k, which turns.
  Index turn_at(std::size_t k, Index heading) {
    if (k >= bend_end_) begin_bend(k, heading);
    turned_ += steps_[k].turn;
    return bend_base_ + right_angles(turned_ * bend_scale_);
  }

  /// All that turns one way from step k on.
  void begin_bend(std::size_t k, Index heading) {
    bend_base_ = heading;
    turned_ = 0;
    double all = 0, gap = 0;
    const int way = way_[k];
    for (bend_end_ = k; k < steps_.size(); ++k) {
      gap += k > bend_end_ ? steps_[k].length : 0;
      if (way_[k] == -way || gap > bend_gap) break;
      if (way_[k] == 0) continue;
      all += steps_[k].turn;
      gap = 0;
      bend_end_ = k + 1;
    }
    bend_scale_ = 0.5 * pi * right_angles(all) / all;
  }

  /// The border began on the way along a curve; the end goes on in the direction of the start.
  void join_ends() {
    if (border_.sides.size() == 1) return;
    const Side last = border_.sides.back();
    border_.sides.pop_back();
    for (Index k = 0; k < right_angles_round; ++k)
      border_.sides.front().length[direction(k - border_.turns)] += last.length[k];
  }

  /// Which way the border turns at the end of step k: 1, -1, or 0 if it does not.
  int way_at(std::size_t k) const {
    const auto sign = [](double turn) { return turn > 0 ? 1 : -1; };
    if (is_sharp(steps_[k])) return sign(steps_[k].turn);
    const double reach = std::min(tight_reach, 0.5 * round_);
    const double around = steps_[k].turn + turn_ahead(k, reach) + turn_behind(k, reach);
    return std::abs(around) < tight_turn ? 0 : sign(around);
  }

  double turn_ahead(std::size_t k, double reach) const {
    double turn = 0;
    for (std::size_t most = steps_.size(); most > 0; --most) {
      k = k + 1 < steps_.size() ? k + 1 : 0;
      reach -= steps_[k].length;
      if (reach < 0 || is_sharp(steps_[k])) break;
      turn += steps_[k].turn;
    }
    return turn;
  }

  double turn_behind(std::size_t k, double reach) const {
    double turn = 0;
    for (std::size_t most = steps_.size(); most > 0; --most) {
      reach -= steps_[k].length;
      k = k > 0 ? k - 1 : steps_.size() - 1;
      if (reach < 0 || is_sharp(steps_[k])) break;
      turn += steps_[k].turn;
    }
    return turn;
  }

  std::vector<BorderStep> steps_;
  std::vector<int> way_;  // #steps
  double round_ = 0;      // length in all
  double straight_ = 0;   // the longest straight way
  std::size_t bend_end_ = 0;
  Index bend_base_ = 0;
  double bend_scale_ = 1, turned_ = 0;
  Border border_;
};

class BorderWalker {
 public:
  BorderWalker(const SurfaceMesh& mesh, const SurfaceFeatures& features,
               const SurfaceCurves& curves, std::span<const double> steps)
      : mesh_(mesh),
        features_(features),
        curve_of_(features.kind.size(), none),
        size_(steps.size(), 1),
        done_(mesh.twins.size(), 0) {
    for (Index c = 0; c < curves.count(); ++c) {
      double length = 0;
      for (const Index edge : curves.edges.row(c)) {
        curve_of_[edge] = c;
        length += distance(mesh.points[features.edges.ends[edge][0]],
                           mesh.points[features.edges.ends[edge][1]]);
      }
      if (length > 0 && steps[c] > 0) size_[c] = length / steps[c];
    }
  }

  /// In order of their first half-edge, those that start at a corner before those without one.
  std::vector<Border> run() {
    std::vector<Border> borders;
    for (const bool from_corners : {true, false})
      for (Index e = 0; e < static_cast<Index>(mesh_.twins.size()); ++e)
        if (!done_[e] && features_.half_edge_is_feature(e) &&
            features_.corner[mesh_.origin(e)] == from_corners)
          borders.push_back(walk(e));
    return borders;
  }

 private:
  Border walk(Index e) {
    const Index face = features_.face[triangle_of(e)];
    std::vector<BorderStep> steps;
    while (!done_[e]) {
      done_[e] = 1;
      BorderStep step;
      step.curve = curve_of_[features_.edges.edge_of[e]];
      step.length = distance(mesh_.points[mesh_.origin(e)], mesh_.points[mesh_.target(e)]) /
                    size_[step.curve];
      step.ends_curve = features_.corner[mesh_.target(e)];
      double angle = 0;
      e = next_on_border(e, angle);
      step.turn = pi - angle;
      steps.push_back(step);
    }
    Border border = Turns(std::move(steps)).run();
    border.face = face;
    return border;
  }

  /// Goes round the target of e, adding up the angles of the face there.
  Index next_on_border(Index e, double& angle) const {
    for (e = next_in_triangle(e);; e = next_in_triangle(mesh_.twins[e])) {
      angle += corner_angle(e);
      if (features_.half_edge_is_feature(e)) return e;
    }
  }

  double corner_angle(Index e) const {
    const Vec3 p = mesh_.points[mesh_.origin(e)];
    const Vec3 a = mesh_.points[mesh_.target(e)] - p, b = mesh_.points[mesh_.apex(e)] - p;
    return arc_tangent(length(cross(a, b)), dot(a, b));
  }

  const SurfaceMesh& mesh_;
  const SurfaceFeatures& features_;
  std::vector<Index> curve_of_;  // #E
  std::vector<double> size_;     // #C  mean mesh size
  std::vector<char> done_;       // #half-edges
};

/// +1 along the direction, -1 against it, 0 across.
Index sign_along(Index along, Index side_direction) {
  const Index turned = direction(side_direction - along);
  return turned % 2 == 1 ? 0 : 1 - turned;
}

double length_along(Index along, const Side& side) {
  double length = 0;
  for (Index k = 0; k < right_angles_round; ++k) length += sign_along(along, k) * side.length[k];
  return length;
}

/// The direction in which a border goes round a ring.
Index way_round(const Border& border) {
  Index best = 0;
  double most = 0;
  for (Index along = 0; along < right_angles_round; ++along) {
    double length = 0;
    for (const Side& side : border.sides) length += length_along(along, side);
    if (!(length > most)) continue;
    most = length;
    best = along;
  }
  return best;
}

class SumMaker {
 public:
  explicit SumMaker(const SurfaceCurves& curves) : curves_(curves) {}

  CountSums run(const std::vector<Border>& borders, Index face_count) {
    sums_.bent.assign(curves_.is_loop.size(), 0);
    std::vector<std::vector<const Border*>> of_face(face_count);
    for (const Border& border : borders) {
      of_face[border.face].push_back(&border);
      for (const Side& side : border.sides) count_bent(side);
    }
    for (const auto& around : of_face) add_face(around);
    return std::move(sums_);
  }

 private:
  bool is_closed(Index c) const {
    return curves_.vertices.row(c).front() == curves_.vertices.row(c).back();
  }

  /// Whole edges in each direction.
  void count_bent(const Side& side) {
    if (side.is_straight() || is_closed(side.curve) || sums_.bent[side.curve] > 0) return;
    for (const double length : side.length) sums_.bent[side.curve] += rounded(length);
  }

  /// How many edges more a bent side has along a direction than against it.
  Index bent_along(Index along, const Side& side) const {
    if (is_closed(side.curve)) return 0;
    std::array<Index, right_angles_round> edges{};
    Index left = sums_.bent[side.curve];
    for (Index k = 0; k < right_angles_round; ++k) left -= edges[k] = rounded(side.length[k]);
    edges[side.main_direction()] += left;  // if the curve bends otherwise on its other side
    Index sum = 0;
    for (Index k = 0; k < right_angles_round; ++k) sum += sign_along(along, k) * edges[k];
    return sum;
  }

  void add_face(const std::vector<const Border*>& around) {
    std::vector<const Border*> others;
    for (const Border* border : around) {
      if (border->turns != right_angles_round && border->turns != -right_angles_round) {
        others.push_back(border);
        continue;
      }
      for (const Index direction : {0, 1}) {
        add_terms(*border, direction, 1);
        end_sum(false);
      }
    }
    if (others.size() > 2)
      std::stable_partition(others.begin(), others.end(),
                            [](const Border* b) { return !b->round; });
    const bool only_holes_left =
        std::all_of(others.begin() + std::min<std::size_t>(others.size(), 2), others.end(),
                    [](const Border* b) { return b->round; });
    if (others.size() >= 2 && only_holes_left && others[0]->turns == 0 && others[1]->turns == 0 &&
        others[0]->round == others[1]->round) {
      add_ring(*others[0], *others[1]);
      others.erase(others.begin(), others.begin() + 2);
    }
    for (const Border* border : others)
      for (const Side& side : border->sides) row_.push_back({side.curve, 1});
    end_sum(true);
  }

  void add_ring(const Border& a, const Border& b) {
    const Index along_a = way_round(a), along_b = way_round(b);
    add_terms(a, along_a + 1, 1);
    end_sum(false);
    add_terms(b, along_b + 1, 1);
    end_sum(false);
    add_terms(a, along_a, 1);
    add_terms(b, along_b, -1);
    end_sum(false, a.round);
  }

  void add_terms(const Border& border, Index direction, Index sign) {
    for (const Side& side : border.sides) {
      if (!side.is_straight()) {
        constant_ += sign * bent_along(direction, side);
      } else if (const Index along = sign_along(direction, side.main_direction()); along != 0) {
        row_.push_back({side.curve, sign * along});
      }
    }
  }

  /// Both sides of one curve add up.
  void end_sum(bool only_parity, bool between_circles = false) {
    std::sort(row_.begin(), row_.end(),
              [](const CountTerm& a, const CountTerm& b) { return a.curve < b.curve; });
    std::vector<CountTerm>& terms = sums_.terms.values;
    const std::size_t first = terms.size();
    for (const CountTerm& term : row_) {
      if (terms.size() == first || terms.back().curve != term.curve) {
        terms.push_back(term);
      } else {
        terms.back().factor += term.factor;
      }
    }
    const auto nothing = [&](const CountTerm& term) {
      return term.factor == 0 || (only_parity && term.factor % 2 == 0);
    };
    terms.erase(std::remove_if(terms.begin() + first, terms.end(), nothing), terms.end());
    row_.clear();
    if (terms.size() > first) {
      sums_.terms.end_row();
      sums_.constant.push_back(constant_);
      sums_.only_parity.push_back(only_parity);
      sums_.between_circles.push_back(between_circles);
    }
    constant_ = 0;
  }

  const SurfaceCurves& curves_;
  CountSums sums_;
  std::vector<CountTerm> row_;
  Index constant_ = 0;
};

}  // namespace

CountSums side_balances(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                        const SurfaceCurves& curves, std::span<const double> steps) {
  const std::vector<Border> borders = BorderWalker(mesh, features, curves, steps).run();
  return SumMaker(curves).run(borders, features.face_count);
}

}  // namespace lpq

#include "surface/face_borders.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numerics/elementary.h"

namespace lpq {
namespace {

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

/// Lengths too short for a side of their own go to the main direction.
void drop_little_pieces(BorderSide& side) {
  const Index main = side.main_direction();
  for (Index k = 0; k < right_angles_round; ++k) {
    if (k == main || side.length[k] >= little) continue;
    side.length[main] += side.length[k];
    side.length[k] = 0;
  }
}

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

  FaceBorder run() {
    bool starts_curve = true;
    Index heading = 0;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const BorderStep& step = steps_[k];
      if (starts_curve) border_.sides.push_back({step.curve, {}});
      border_.sides.back().length[direction_after(heading)] += step.length;
      starts_curve = step.ends_curve;
      if (way_[k] != 0) heading = turn_at(k, heading);
    }
    border_.turns = heading;
    if (is_round()) make_round();
    if (!starts_curve) join_ends();
    for (BorderSide& side : border_.sides) drop_little_pieces(side);
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
    bend_scale_ = all != 0 ? 0.5 * pi * right_angles(all) / all : 0;
  }

  /// The border began on the way along a curve; the end goes on in the direction of the start.
  void join_ends() {
    if (border_.sides.size() == 1) return;
    const BorderSide last = border_.sides.back();
    border_.sides.pop_back();
    for (Index k = 0; k < right_angles_round; ++k)
      border_.sides.front().length[direction_after(k - border_.turns)] += last.length[k];
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
  FaceBorder border_;
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
  std::vector<FaceBorder> run() {
    std::vector<FaceBorder> borders;
    for (const bool from_corners : {true, false})
      for (Index e = 0; e < static_cast<Index>(mesh_.twins.size()); ++e)
        if (!done_[e] && features_.half_edge_is_feature(e) &&
            features_.corner[mesh_.origin(e)] == from_corners)
          borders.push_back(walk(e));
    return borders;
  }

 private:
  FaceBorder walk(Index e) {
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
    FaceBorder border = Turns(std::move(steps)).run();
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

}  // namespace

Index direction_after(Index right_angles) {
  return (right_angles % right_angles_round + right_angles_round) % right_angles_round;
}

Index BorderSide::main_direction() const {
  return static_cast<Index>(std::max_element(length.begin(), length.end()) - length.begin());
}

double BorderSide::whole() const { return std::accumulate(length.begin(), length.end(), 0.0); }

std::vector<FaceBorder> face_borders(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                                     const SurfaceCurves& curves, std::span<const double> steps) {
  return BorderWalker(mesh, features, curves, steps).run();
}

}  // namespace lpq

#include "surface/side_balance.h"

#include <algorithm>
#include <array>

#include "numerics/elementary.h"

namespace lpq {
namespace {

constexpr Index right_angles_round = 4;

/// Part of a border on one curve, `direction` right angles from where the border began.
struct Side {
  Index curve = none, direction = 0;
  double length = 0;
};

struct Border {
  Index face = none, turns = 0;  // in all
  std::vector<Side> sides;
};

class BorderWalker {
 public:
  BorderWalker(const SurfaceMesh& mesh, const SurfaceFeatures& features,
               const SurfaceCurves& curves)
      : mesh_(mesh),
        features_(features),
        curve_of_(features.kind.size(), none),
        done_(mesh.twins.size(), 0) {
    for (Index c = 0; c < curves.count(); ++c)
      for (const Index edge : curves.edges.row(c)) curve_of_[edge] = c;
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
    Border border;
    border.face = features_.face[triangle_of(e)];
    bool starts_curve = true;
    while (!done_[e]) {
      done_[e] = 1;
      if (starts_curve)
        border.sides.push_back({curve_of_[features_.edges.edge_of[e]], border.turns});
      border.sides.back().length +=
          distance(mesh_.points[mesh_.origin(e)], mesh_.points[mesh_.target(e)]);
      starts_curve = features_.corner[mesh_.target(e)];
      double angle = 0;
      e = next_on_border(e, angle);
      if (starts_curve) border.turns += right_angles(pi - angle);
    }
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

  static Index right_angles(double turn) {
    const double quarters = turn / (0.5 * pi);
    return static_cast<Index>(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
  }

  const SurfaceMesh& mesh_;
  const SurfaceFeatures& features_;
  std::vector<Index> curve_of_;  // #E
  std::vector<char> done_;       // #half-edges
};

/// +1 along the direction, -1 against it, 0 across.
Index sign_along(Index direction, Index side_direction) {
  const Index turned =
      ((side_direction - direction) % right_angles_round + right_angles_round) % right_angles_round;
  return turned % 2 == 1 ? 0 : 1 - turned;
}

/// The direction in which a border goes round a ring.
Index way_round(const Border& border) {
  Index best = 0;
  double most = 0;
  for (Index direction = 0; direction < right_angles_round; ++direction) {
    double length = 0;
    for (const Side& side : border.sides)
      length += sign_along(direction, side.direction) * side.length;
    if (!(length > most)) continue;
    most = length;
    best = direction;
  }
  return best;
}

class SumMaker {
 public:
  CountSums run(const std::vector<Border>& borders, Index face_count) {
    std::vector<std::vector<const Border*>> of_face(face_count);
    for (const Border& border : borders) of_face[border.face].push_back(&border);
    for (const auto& around : of_face) {
      if (around.size() == 2 && around[0]->turns == 0 && around[1]->turns == 0) {
        add_ring(*around[0], *around[1]);
      } else {
        add_face(around);
      }
    }
    return std::move(sums_);
  }

 private:
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
    end_sum(false);
  }

  void add_terms(const Border& border, Index direction, Index sign) {
    for (const Side& side : border.sides)
      if (const Index along = sign_along(direction, side.direction); along != 0)
        row_.push_back({side.curve, sign * along});
  }

  /// Both sides of one curve add up.
  void end_sum(bool only_parity) {
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
    if (terms.size() == first) return;
    sums_.terms.end_row();
    sums_.only_parity.push_back(only_parity);
  }

  CountSums sums_;
  std::vector<CountTerm> row_;
};

}  // namespace

CountSums side_balances(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                        const SurfaceCurves& curves) {
  const std::vector<Border> borders = BorderWalker(mesh, features, curves).run();
  return SumMaker().run(borders, features.face_count);
}

}  // namespace lpq

#include "surface/side_balance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/sort_numbers.h"
#include "numerics/elementary.h"
#include "surface/face_borders.h"
#include "surface/narrow_band.h"

namespace lpq {
namespace {

// A round hole bounds a ring with a border round it that is up to so many times as long.
constexpr double wide_ring = 2;
// Of a face whose rings are plain, 1 that of a sphere's half.
constexpr double most_curvature = 0.03;

/// A length in edges.
Index rounded(double length) { return static_cast<Index>(std::floor(length + 0.5)); }

/// +1 along the direction, -1 against it, 0 across.
Index sign_along(Index along, Index side_direction) {
  const Index turned = direction_after(side_direction - along);
  return turned % 2 == 1 ? 0 : 1 - turned;
}

double length_along(Index along, const BorderSide& side) {
  double length = 0;
  for (Index k = 0; k < right_angles_round; ++k) length += sign_along(along, k) * side.length[k];
  return length;
}

double length_along(Index along, const FaceBorder& border) {
  double length = 0;
  for (const BorderSide& side : border.sides) length += length_along(along, side);
  return length;
}

/// The direction in which a border goes round a ring.
Index way_round(const FaceBorder& border) {
  Index best = 0;
  double most = 0;
  for (Index along = 0; along < right_angles_round; ++along) {
    const double length = length_along(along, border);
    if (!(length > most)) continue;
    most = length;
    best = along;
  }
  return best;
}

double length_round(const FaceBorder& border) { return length_along(way_round(border), border); }

class SumMaker {
 public:
  explicit SumMaker(const SurfaceCurves& curves) : curves_(curves) {}

  CountSums run(const std::vector<FaceBorder>& borders, std::span<const double> areas) {
    sums_.bent.assign(curves_.is_loop.size(), 0);
    std::vector<std::vector<const FaceBorder*>> of_face(areas.size());
    for (const FaceBorder& border : borders) {
      of_face[border.face].push_back(&border);
      for (const BorderSide& side : border.sides) count_bent(side);
    }
    for (std::size_t face = 0; face < areas.size(); ++face) add_face(of_face[face], areas[face]);
    return std::move(sums_);
  }

 private:
  bool is_closed(Index c) const {
    return curves_.vertices.row(c).front() == curves_.vertices.row(c).back();
  }

  /// Whole edges in each direction.
  void count_bent(const BorderSide& side) {
    if (side.is_straight() || is_closed(side.curve) || sums_.bent[side.curve] > 0) return;
    for (const double length : side.length) sums_.bent[side.curve] += rounded(length);
  }

  /// The edges of a bent side in each direction; none of a closed curve.
  std::array<Index, right_angles_round> bent_edges(const BorderSide& side) const {
    std::array<Index, right_angles_round> edges{};
    if (is_closed(side.curve)) return edges;
    Index left = sums_.bent[side.curve];
    for (Index k = 0; k < right_angles_round; ++k) left -= edges[k] = rounded(side.length[k]);
    edges[side.main_direction()] += left;  // if the curve bends otherwise on its other side
    return edges;
  }

  /// How many edges more a bent side has along a direction than against it.
  Index bent_along(Index along, const BorderSide& side) const {
    const auto edges = bent_edges(side);
    Index sum = 0;
    for (Index k = 0; k < right_angles_round; ++k) sum += sign_along(along, k) * edges[k];
    return sum;
  }

  void add_face(const std::vector<const FaceBorder*>& around, double area) {
    if (const auto band = narrow_band(around, area)) return add_band(*band);
    std::vector<const FaceBorder*> others;
    bool has_outline = false;  // then all others are holes
    for (const FaceBorder* border : around) {
      if (border->turns != right_angles_round && border->turns != -right_angles_round) {
        others.push_back(border);
        continue;
      }
      has_outline = has_outline || border->turns > 0;
      for (const Index direction : {0, 1}) {
        add_terms(*border, direction, 1);
        end_sum(false);
      }
    }
    sort_values(others, comes_first);
    if (!has_outline && are_ring(others)) {
      add_ring(*others[0], *others[1], is_even(around));
      others.erase(others.begin(), others.begin() + 2);
    }
    for (const FaceBorder* border : others) {
      for (const BorderSide& side : border->sides) row_.push_back({side.curve, 1});
      end_sum(true);
    }
  }

  /// Round ones last, by their lengths; else as they are in their vector.
  static bool comes_first(const FaceBorder* a, const FaceBorder* b) {
    if (a->round != b->round) return b->round;
    const double by = a->round ? length_round(*a) - length_round(*b) : 0;
    return by != 0 ? by > 0 : a < b;
  }

  /// Are the first two opposite borders of a ring, and the others its holes?
  static bool are_ring(std::span<const FaceBorder* const> borders) {
    if (borders.size() < 2) return false;
    const FaceBorder &a = *borders[0], &b = *borders[1];
    if (a.turns != 0 || b.turns != 0) return false;
    if (a.round != b.round && length_round(a) > wide_ring * length_round(b)) return false;
    return std::all_of(borders.begin() + 2, borders.end(),
                       [](const FaceBorder* border) { return border->round; });
  }

  /// Has a disk with such holes no curvature in all [Gauss, Bonnet]? Then none asks for irregular
  /// vertices.
  static bool is_even(std::span<const FaceBorder* const> borders) {
    double turns = 0;
    for (const FaceBorder* border : borders) turns += border->angle / (2 * pi);
    return std::fabs(2 - static_cast<double>(borders.size()) - turns) < most_curvature;
  }

  void add_ring(const FaceBorder& a, const FaceBorder& b, bool even) {
    const Index along_a = way_round(a), along_b = way_round(b);
    add_terms(a, along_a + 1, 1);
    end_sum(false);
    add_terms(b, along_b + 1, 1);
    end_sum(false);
    add_terms(a, along_a, 1);
    add_terms(b, along_b, -1);
    const bool circles = a.round || b.round;
    end_sum(false, even || circles, circles);
  }

  void add_terms(const FaceBorder& border, Index direction, Index sign) {
    for (const BorderSide& side : border.sides) {
      if (!side.is_straight()) {
        constant_ += sign * bent_along(direction, side);
      } else if (const Index along = sign_along(direction, side.main_direction()); along != 0) {
        row_.push_back({side.curve, sign * along});
      }
    }
  }

  /// Rows of quads go straight across. Those that run along end at the corners of the outline: on
  /// either side it has that many edges more than what lies opposite.
  void add_band(const NarrowBand& band) {
    for (Index k = 0; k < right_angles_round; ++k) {
      add_one_way(*band.outer, k, 1);
      add_one_way(*band.inner, direction_after(k + band.shift), -1);
      constant_ -= 2 * band.rows;
      end_sum(false, true);
    }
  }

  void add_one_way(const FaceBorder& border, Index way, Index sign) {
    for (const BorderSide& side : border.sides) {
      if (!side.is_straight()) {
        constant_ += sign * bent_edges(side)[way];
      } else if (side.main_direction() == way) {
        row_.push_back({side.curve, sign});
      }
    }
  }

  /// Both sides of one curve add up.
  void end_sum(bool only_parity, bool across_ring = false, bool between_circles = false) {
    sort_values(row_, [](const CountTerm& a, const CountTerm& b) { return a.curve < b.curve; });
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
      sums_.across_ring.push_back(across_ring);
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
  std::vector<double> areas(static_cast<std::size_t>(features.face_count), 0);
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    areas[features.face[t]] += triangle_area(mesh, t);
  return SumMaker(curves).run(face_borders(mesh, features, curves, steps), areas);
}

}  // namespace lpq

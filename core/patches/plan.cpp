#include "patches/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/sort_numbers.h"

namespace lpq {
namespace {

// A cut may have this many times the edges that its length asks for, or as few.
constexpr double shortest_cut = 0.6, longest_cut = 1.5;
// A spoke of r edges leaves its irregular vertex r edges from the outline: near is bad.
constexpr double nearness = 0.3;

// The numbers of edges round a piece.
struct Piece {
  std::array<int, most_corners + 2> length{};
  int sides = 0;

  void add(int edges) { length[sides++] = edges; }
  Spokes spokes(LastSide last) const {
    return find_spokes({length.data(), static_cast<std::size_t>(sides)}, last);
  }
};

class Planner {
 public:
  Planner(const Polygon& polygon, const PlanOptions& options)
      : polygon_(polygon), options_(options), n_(polygon.corners()) {}

  std::vector<Plan> run() {
    if (n_ < least_corners || n_ > most_corners) return {};
    Piece whole;
    for (int i = 0; i < n_; ++i) whole.add(polygon_.side_length(i));
    if (n_ <= most_block_corners && whole.spokes(LastSide::outline).fits) {
      if (n_ != 4 && options_.most_irregular < 1) return {};
      return {Plan{.irregular = n_ == 4 ? 0 : 1}};
    }
    for (int i = 0; i < n_; ++i)
      for (int j = i + 1; j < n_; ++j) cut_sides(i, j);
    return best();
  }

 private:
  void cut_sides(int i, int j) {
    const int left = j - i + 2, right = n_ - (j - i) + 2;
    if (std::min(left, right) < 3 || std::max(left, right) > most_block_corners) return;
    const int irregular = (left != 4) + (right != 4);
    if (irregular == 0 || irregular > options_.most_irregular) return;
    const int a = polygon_.side_length(i), b = polygon_.side_length(j);
    const int step_a = std::max(1, a / options_.places_per_side);
    const int step_b = std::max(1, b / options_.places_per_side);
    for (int p = 1; p < a; p += step_a)
      for (int q = 1; q < b; q += step_b) cut_places({i, p, j, q, 0, irregular, 0});
  }

  void cut_places(Plan plan) {
    const Index u = polygon_.at(plan.first_side, plan.first_step);
    const Index v = polygon_.at(plan.second_side, plan.second_step);
    const double distance = length(polygon_.points[u] - polygon_.points[v]);
    const double natural = 2 * distance / (polygon_.size[u] + polygon_.size[v]);
    const int least = std::max(1, static_cast<int>(std::floor(shortest_cut * natural)));
    const int most = static_cast<int>(std::ceil(longest_cut * natural)) + 1;
    Piece left, right;
    split(plan, left, right);
    for (plan.edges = least; plan.edges <= most; ++plan.edges) {
      left.length[left.sides - 1] = right.length[right.sides - 1] = plan.edges;
      const Spokes one = left.spokes(LastSide::cut);
      if (!one.fits) continue;
      const Spokes two = right.spokes(LastSide::cut);
      if (!two.fits || meet(left, one, right, two)) continue;
      plan.misfit = std::abs(plan.edges - natural) / std::sqrt(natural + 1) + nearness / one.least +
                    nearness / two.least;
      found_.push_back(plan);
    }
  }

  // Both irregular vertices on the cut, in the same place: one of another valence.
  static bool meet(const Piece& left, const Spokes& one, const Piece& right, const Spokes& two) {
    if (left.sides == 4 || right.sides == 4) return false;
    if (one.edges[left.sides - 1] != 0 || two.edges[right.sides - 1] != 0) return false;
    return one.edges[left.sides - 2] + two.edges[right.sides - 2] == left.length[left.sides - 1];
  }

  // The pieces left and right of the cut; the cut is the last side of both.
  void split(const Plan& plan, Piece& left, Piece& right) const {
    const int i = plan.first_side, j = plan.second_side;
    left.add(polygon_.side_length(i) - plan.first_step);
    for (int k = i + 1; k < j; ++k) left.add(polygon_.side_length(k));
    left.add(plan.second_step);
    left.add(0);
    right.add(polygon_.side_length(j) - plan.second_step);
    for (int k = j + 1; k < i + n_; ++k) right.add(polygon_.side_length(k % n_));
    right.add(plan.first_step);
    right.add(0);
  }

  std::vector<Plan> best() {
    const std::vector<Index> order = sorted_numbers(found_.size(), [&](Index i, Index j) {
      const Plan &a = found_[i], &b = found_[j];
      if (a.irregular != b.irregular) return a.irregular < b.irregular;
      return a.misfit != b.misfit ? a.misfit < b.misfit : i < j;
    });
    std::vector<Plan> chosen;
    for (const Index i : order) {
      const Plan& plan = found_[i];
      if (static_cast<int>(chosen.size()) == options_.count) break;
      const auto beside = [&](const Plan& other) {
        return other.first_side == plan.first_side && other.second_side == plan.second_side &&
               std::abs(other.first_step - plan.first_step) +
                       std::abs(other.second_step - plan.second_step) <=
                   1;
      };
      if (std::none_of(chosen.begin(), chosen.end(), beside)) chosen.push_back(plan);
    }
    return chosen;
  }

  const Polygon& polygon_;
  const PlanOptions& options_;
  int n_;
  std::vector<Plan> found_;
};

VertexRow part_of_side(const Polygon& polygon, int side, int from, int to) {
  VertexRow part;
  for (int step = from; step <= to; ++step) part.push_back(polygon.at(side, step));
  return part;
}

VertexRow whole_side(const Polygon& polygon, int side) {
  return part_of_side(polygon, side, 0, polygon.side_length(side));
}

void fill_cut(const Polygon& polygon, const Plan& plan, Filling& filling) {
  const int n = polygon.corners(), i = plan.first_side, j = plan.second_side;
  const Index u = polygon.at(i, plan.first_step), v = polygon.at(j, plan.second_step);
  const VertexRow cut = straight_side(v, u, plan.edges, filling);
  std::vector<VertexRow> left{part_of_side(polygon, i, plan.first_step, polygon.side_length(i))};
  for (int k = i + 1; k < j; ++k) left.push_back(whole_side(polygon, k));
  left.push_back(part_of_side(polygon, j, 0, plan.second_step));
  left.push_back(cut);
  std::vector<VertexRow> right{part_of_side(polygon, j, plan.second_step, polygon.side_length(j))};
  for (int k = j + 1; k < i + n; ++k) right.push_back(whole_side(polygon, k % n));
  right.push_back(part_of_side(polygon, i, 0, plan.first_step));
  right.push_back(VertexRow(cut.rbegin(), cut.rend()));
  fill_block(left, filling);
  fill_block(right, filling);
}

}  // namespace

std::vector<Plan> make_plans(const Polygon& polygon, const PlanOptions& options) {
  return Planner(polygon, options).run();
}

Filling fill(const Polygon& polygon, const Plan& plan) {
  Filling filling;
  filling.points = polygon.points;
  if (plan.first_side != none) {
    fill_cut(polygon, plan, filling);
    return filling;
  }
  std::vector<VertexRow> sides;
  for (int i = 0; i < polygon.corners(); ++i) sides.push_back(whole_side(polygon, i));
  fill_block(sides, filling);
  return filling;
}

}  // namespace lpq

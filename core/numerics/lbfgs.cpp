// L-BFGS: two-loop recursion [Nocedal 1980] and a bracketing line search for the weak Wolfe
// conditions [Lewis, Overton 2013], which never asks for more smoothness than the L_p energy has
// (C^1 across Delaunay flips). Differences from the usual library: a trial point may be refused by
// the objective (the bracket shrinks, paper section 3.3.1), a step is capped so that no unknown
// moves beyond its limit, and every accepted value is strictly lower than the last. Oscillation
// (paper section 3.3.3) can then only show as a value that no longer drops, which the stagnation
// rule ends. All sums run in a fixed order. Cost per iteration: 4 memory n flops + one evaluation.
#include "numerics/lbfgs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"

namespace lpq {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Wolfe conditions: decrease by at least this share of the slope, slope reduced to this share.
constexpr double sufficient_decrease = 1e-4;
constexpr double sufficient_flattening = 0.9;
// A pair whose angle between s and y is this close to 90 degrees carries only rounding noise.
constexpr double least_cosine_squared = 1e-20;
// Where to try next inside the bracket when interpolation has nothing to say (refused point), and
// how near to its ends interpolation may go.
constexpr double refused_share = 0.4;
constexpr double least_share = 0.1, largest_share = 0.5;
constexpr double expansion = 2.5;

// Sums in four interleaved lanes, always folded the same way: fast, and the same bits everywhere.
constexpr std::size_t lanes = 4;

double fold(const std::array<double, lanes>& sum) { return (sum[0] + sum[2]) + (sum[1] + sum[3]); }

double dot_product(std::span<const double> a, std::span<const double> b) {
  std::array<double, lanes> sum{};
  const std::size_t whole = a.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) sum[k] += a[i + k] * b[i + k];
  for (std::size_t i = whole; i < a.size(); ++i) sum[i - whole] += a[i] * b[i];
  return fold(sum);
}

// a += factor b, and the product of the new a with c: one pass over memory instead of two.
double add_and_dot(std::span<double> a, double factor, std::span<const double> b,
                   std::span<const double> c) {
  std::array<double, lanes> sum{};
  const std::size_t whole = a.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double value = a[i + k] + factor * b[i + k];
      a[i + k] = value;
      sum[k] += value * c[i + k];
    }
  for (std::size_t i = whole; i < a.size(); ++i) {
    a[i] += factor * b[i];
    sum[i - whole] += a[i] * c[i];
  }
  return fold(sum);
}

double largest_magnitude(std::span<const double> a) {
  double largest = 0;
  for (const double value : a) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

Lbfgs::Lbfgs(std::vector<double> x0, LbfgsOptions options, std::vector<double> move_limit)
    : x_(std::move(x0)),
      gradient_(x_.size(), 0.0),
      move_limit_(std::move(move_limit)),
      options_(options),
      direction_(x_.size(), 0.0),
      trial_x_(x_.size(), 0.0),
      trial_gradient_(x_.size(), 0.0) {
  LPQ_ASSERT(move_limit_.empty() || move_limit_.size() == x_.size());
  options_.memory = std::clamp(options_.memory, 1, 50);
  const std::size_t rows = static_cast<std::size_t>(options_.memory);
  s_.resize(rows * x_.size());
  y_.resize(rows * x_.size());
  inverse_sy_.resize(rows);
}

LbfgsStatus Lbfgs::step(int n, Objective objective) {
  if (!started_) evaluate_start(objective);
  for (int i = 0; i < n && status_ == LbfgsStatus::running; ++i) iterate(objective);
  return status_;
}

void Lbfgs::evaluate_start(Objective objective) {
  started_ = true;
  const Evaluation start = objective(x_, gradient_);
  ++evaluations_;
  value_ = start.value;
  if (start.status != EvalStatus::ok || !std::isfinite(value_)) {
    status_ = LbfgsStatus::stalled;
    return;
  }
  values_.push_back(value_);
  gradient_norms_.push_back(largest_magnitude(gradient_));
  judge();
}

void Lbfgs::iterate(Objective objective) {
  for (;;) {
    find_direction();
    const double slope = dot_product(gradient_, direction_);
    const bool descends = slope < 0 && std::isfinite(slope);
    if (descends && line_search(slope, objective)) break;
    if (pairs_ == 0) {
      status_ = LbfgsStatus::stalled;
      return;
    }
    pairs_ = 0;  // forget the curvature and try again along steepest descent
  }
  ++iterations_;
  values_.push_back(value_);
  gradient_norms_.push_back(largest_magnitude(gradient_));
  judge();
}

void Lbfgs::judge() {
  if (gradient_norms_.back() <= options_.gradient_tolerance * gradient_norms_.front()) {
    status_ = LbfgsStatus::converged;
    return;
  }
  const std::size_t window = static_cast<std::size_t>(std::max(1, options_.stagnation_window));
  if (values_.size() <= window) return;
  const double drop = values_[values_.size() - 1 - window] - value_;
  if (drop <= options_.value_tolerance * std::abs(value_)) status_ = LbfgsStatus::stagnated;
}

std::span<const double> Lbfgs::pair_s(int age) const {
  const std::size_t row =
      static_cast<std::size_t>((newest_ + options_.memory - age) % options_.memory);
  return {s_.data() + row * x_.size(), x_.size()};
}

std::span<const double> Lbfgs::pair_y(int age) const {
  const std::size_t row =
      static_cast<std::size_t>((newest_ + options_.memory - age) % options_.memory);
  return {y_.data() + row * x_.size(), x_.size()};
}

// direction = -H g with H the inverse Hessian implied by the pairs [Nocedal 1980]. Additions are
// fused with the product that the next turn needs.
void Lbfgs::find_direction() {
  for (std::size_t i = 0; i < x_.size(); ++i) direction_[i] = -gradient_[i];
  if (pairs_ == 0) return;
  std::array<double, 50> alpha{};
  const auto inverse_sy = [&](int age) {
    return inverse_sy_[static_cast<std::size_t>((newest_ + options_.memory - age) %
                                                options_.memory)];
  };
  double product = dot_product(pair_s(0), direction_);
  for (int age = 0; age < pairs_; ++age) {
    alpha[static_cast<std::size_t>(age)] = inverse_sy(age) * product;
    const bool last = age + 1 == pairs_;
    product = add_and_dot(direction_, -alpha[static_cast<std::size_t>(age)], pair_y(age),
                          last ? pair_y(age) : pair_s(age + 1));
  }
  for (double& d : direction_) d *= inverse_curvature_;
  product *= inverse_curvature_;  // = y . direction for the oldest pair
  for (int age = pairs_ - 1; age >= 0; --age) {
    const double beta = inverse_sy(age) * product;
    product = add_and_dot(direction_, alpha[static_cast<std::size_t>(age)] - beta, pair_s(age),
                          age > 0 ? pair_y(age - 1) : pair_s(age));
  }
}

// The step at which the first unknown reaches its limit.
double Lbfgs::largest_step() const {
  double largest = infinity;
  for (std::size_t i = 0; i < move_limit_.size(); ++i) {
    const double d = std::abs(direction_[i]);
    if (d > 0) largest = std::min(largest, move_limit_[i] / d);
  }
  return largest;
}

// Without pairs the direction has no length of its own: use the last known curvature, but try no
// more than the first-move share of the limits, or a unit length when there are no limits.
double Lbfgs::first_step(double limit) const {
  const double fresh = limit < infinity ? (iterations_ == 0 ? 1.0 : options_.first_move) * limit
                                        : 1 / std::sqrt(dot_product(gradient_, gradient_));
  return inverse_curvature_ > 0 ? std::min(fresh, inverse_curvature_) : fresh;
}

// Bracket [low, high]: low decreases enough but is still steep, high does not decrease or is
// refused. A step at the cap is accepted although steep. After an overshoot beyond a usable low,
// one interpolated trial, then low itself: curvature is a wish, decrease is the duty.
bool Lbfgs::line_search(double slope, Objective objective) {
  const double cap = (iterations_ == 0 ? options_.first_move : 1.0) * largest_step();
  double step = std::min(cap, pairs_ == 0 ? first_step(cap) : 1.0);
  double low = 0, low_value = value_, low_slope = slope, high = infinity;
  bool settle = false;
  for (int trial = 0; trial < options_.max_backtracks; ++trial) {
    for (std::size_t i = 0; i < x_.size(); ++i) trial_x_[i] = x_[i] + step * direction_[i];
    const Evaluation here = objective(trial_x_, trial_gradient_);
    ++evaluations_;
    const bool admissible = here.status == EvalStatus::ok && std::isfinite(here.value);
    if (admissible && here.value < value_ &&
        here.value <= value_ + sufficient_decrease * step * slope) {
      trial_value_ = here.value;
      const double here_slope = dot_product(trial_gradient_, direction_);
      const bool flat = here_slope >= sufficient_flattening * slope;
      if (flat || step >= cap || settle || trial + 3 >= options_.max_backtracks) {
        accept();
        return true;
      }
      low = step, low_value = here.value, low_slope = here_slope;
      step = high < infinity ? low + refused_share * (high - low) : std::min(cap, expansion * step);
      continue;
    }
    high = step;
    double share = refused_share;
    if (admissible) {
      // Minimum of the parabola through low (value and slope) and here (value).
      const double width = high - low, excess = here.value - low_value - low_slope * width;
      if (excess > 0) share = -0.5 * low_slope * width / excess;
      share = std::clamp(share, least_share, largest_share);
    }
    step = settle ? low : low + share * (high - low);
    settle = low > 0;
  }
  return false;
}

// Stores the pair, then moves to the trial point.
void Lbfgs::accept() {
  const int row = pairs_ == 0 ? 0 : (newest_ + 1) % options_.memory;
  const std::size_t offset = static_cast<std::size_t>(row) * x_.size();
  const std::span<double> s(s_.data() + offset, x_.size()), y(y_.data() + offset, x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i) {
    s[i] = trial_x_[i] - x_[i];
    y[i] = trial_gradient_[i] - gradient_[i];
  }
  const double sy = dot_product(s, y), ss = dot_product(s, s), yy = dot_product(y, y);
  if (sy > 0 && sy * sy > least_cosine_squared * ss * yy) {
    newest_ = row;
    pairs_ = std::min(pairs_ + 1, options_.memory);
    inverse_sy_[static_cast<std::size_t>(row)] = 1 / sy;
    inverse_curvature_ = sy / yy;
  }
  std::swap(x_, trial_x_);
  std::swap(gradient_, trial_gradient_);
  value_ = trial_value_;
}

}  // namespace lpq

// Limited-memory BFGS [Liu, Nocedal 1989] as a resumable, copyable value. Knows no geometry: the
// unknowns are a flat array, the objective says whether a point is admissible, and the line search
// understands "no" (paper section 3.3.1 without the fake energy of 1e9).
#pragma once

#include <span>
#include <vector>

#include "base/function_ref.h"

namespace lpq {

enum class EvalStatus {
  ok,
  outside_domain,  // an unknown left its admissible set; value and gradient are meaningless
  degenerate,      // not computable here
};

struct Evaluation {
  double value = 0;
  EvalStatus status = EvalStatus::ok;
};

/// Fills `gradient` (same size as x) and returns the value.
using Objective = FunctionRef<Evaluation(std::span<const double> x, std::span<double> gradient)>;

struct LbfgsOptions {
  int memory = 7;                     // correction pairs kept, 1 .. 50
  double gradient_tolerance = 1e-10;  // stop when |g|_inf <= this times the first |g|_inf
  double value_tolerance = 1e-9;  // stagnation: relative drop over `stagnation_window` iterations
  int stagnation_window = 5;
  double first_move = 0.3;  // first step moves at most this share of the move limits
  int max_backtracks = 20;  // trials per line search
};

enum class LbfgsStatus {
  running,
  converged,  // gradient tolerance met
  stagnated,  // value no longer drops
  stalled,    // no admissible lower point along steepest descent
};

class Lbfgs {
 public:
  /// `move_limit[i]` bounds the change of unknown i per iteration (infinity allowed; empty = none).
  Lbfgs(std::vector<double> x0, LbfgsOptions options = {}, std::vector<double> move_limit = {});

  /// Runs up to n more iterations; every accepted value is lower than the one before it.
  /// step(10) gives bit for bit what ten calls of step(1) give. n = 0 only evaluates the start.
  LbfgsStatus step(int n, Objective objective);

  LbfgsStatus status() const { return status_; }
  const std::vector<double>& x() const { return x_; }
  double value() const { return value_; }
  const std::vector<double>& gradient() const { return gradient_; }
  int iterations() const { return iterations_; }
  int evaluations() const { return evaluations_; }
  /// The limits may be changed between iterations (same size as given to the constructor).
  std::span<double> move_limits() { return move_limit_; }

  /// Entry k belongs to the point after k iterations; entry 0 to the start.
  const std::vector<double>& value_history() const { return values_; }
  const std::vector<double>& gradient_norm_history() const { return gradient_norms_; }

 private:
  void evaluate_start(Objective objective);
  void iterate(Objective objective);
  void find_direction();
  bool line_search(double slope, Objective objective);
  double largest_step() const;
  double first_step(double limit) const;
  void accept();
  void judge();
  std::span<const double> pair_s(int age) const;  // age 0 = newest
  std::span<const double> pair_y(int age) const;

  std::vector<double> x_, gradient_, move_limit_;
  LbfgsOptions options_;
  LbfgsStatus status_ = LbfgsStatus::running;
  double value_ = 0;
  int iterations_ = 0, evaluations_ = 0;
  std::vector<double> values_, gradient_norms_;

  bool started_ = false;
  std::vector<double> direction_, trial_x_, trial_gradient_;
  double trial_value_ = 0;
  // Correction pairs s = x' - x, y = g' - g in a ring of `memory` rows.
  std::vector<double> s_, y_, inverse_sy_;
  int pairs_ = 0, newest_ = 0;
  double inverse_curvature_ = 0;  // s.y / y.y of the last pair; survives a restart; 0 = none yet
};

}  // namespace lpq

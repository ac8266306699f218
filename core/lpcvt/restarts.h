// L_p with a count that fits: once the points have settled, some are exchanged (population.h) and
// L-BFGS starts again; what has not become better by then is undone. A resumable, copyable value
// like the optimiser it repeats.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "lpcvt/optimizer.h"
#include "lpcvt/population.h"

namespace lpq {

struct RestartOptions {
  int rounds = 0;       // at most; 0 = the plain optimiser
  int iterations = 30;  // of each round; changes are local and settle sooner than a start
  // Of the points, inserted or removed in one round, or a quarter of what is missing at the start
  // if that is more; halved by each failure.
  double share = 0.02;
};

/// An exchange and what became of it.
struct RestartRound {
  Index inserted = 0, removed = 0;
  bool kept = false;
  double priced_energy = 0;  // once the points had settled again
};

class LpRestarts {
 public:
  /// `boundary`, `fields` must outlive this. Errors: those of triangulate().
  static Result<LpRestarts> start(const BoundaryMesh& boundary, const Fields& fields,
                                  std::span<const Vec2> seeds, const LpOptions& options = {},
                                  const RestartOptions& restarts = {});

  /// Up to n more iterations; an exchange, or going back at the end, counts as one. Between
  /// exchanges no iteration raises the energy; no kept round raises the priced energy.
  LpStatus step(int n);

  LpStatus status() const { return open_ ? LpStatus::running : optimizer_.status(); }
  int iterations() const { return std::max(0, static_cast<int>(energies_.size()) - 1); }
  int max_iterations() const;
  const TriMesh& mesh() const { return optimizer_.mesh(); }  // its count changes with exchanges
  double energy() const { return optimizer_.energy(); }
  const std::vector<RestartRound>& rounds() const { return rounds_; }

  /// Entry k belongs to the mesh after k iterations, undone rounds included.
  const std::vector<double>& energy_history() const { return energies_; }
  const std::vector<double>& gradient_norm_history() const { return gradient_norms_; }

 private:
  LpRestarts(const BoundaryMesh& boundary, const Fields& fields, const LpOptions& options,
             const RestartOptions& restarts, LpOptimizer optimizer);
  void iterate();
  bool judge();
  bool exchange();
  double priced(const LpOptimizer& optimizer) const;
  void record();

  const BoundaryMesh* boundary_;
  const Fields* fields_;
  LpOptions options_;
  RestartOptions restarts_;
  LpOptimizer optimizer_;
  std::optional<LpOptimizer> before_;  // the settled points that the round began with
  bool open_ = false;                  // there may be another iteration
  Index expected_ = 0;                 // free points
  Index most_ = 0;                     // inserted or removed in the next round
  std::vector<RestartRound> rounds_;
  std::vector<double> energies_, gradient_norms_;
  EnergyWorkspace workspace_;
};

}  // namespace lpq

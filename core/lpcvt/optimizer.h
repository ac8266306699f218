// The optimiser of the paper's section 3.3 as a resumable, copyable value.
#pragma once

#include "base/result.h"
#include "delaunay/delaunay.h"
#include "domain/boundary.h"
#include "lpcvt/energy.h"
#include "numerics/lbfgs.h"

namespace lpq {

struct LpOptions {
  EnergyOptions energy;
  int max_iterations = 80;  // paper: eighty are usually enough
  double max_move = 0.25;   // per iteration and vertex, in units of h
  LbfgsOptions lbfgs;
};

enum class LpStatus { running, converged, stagnated, stalled, iteration_limit };

class LpOptimizer {
 public:
  /// `boundary`, `fields` must outlive the optimiser. Errors: those of triangulate().
  static Result<LpOptimizer> start(const BoundaryMesh& boundary, const Fields& fields,
                                   std::span<const Vec2> seeds, const LpOptions& options = {});

  /// Up to n more iterations; no accepted step raises the energy or lets a vertex leave.
  LpStatus step(int n);

  LpStatus status() const;
  int iterations() const { return lbfgs_.iterations(); }
  int evaluations() const { return lbfgs_.evaluations(); }
  const TriMesh& mesh() const { return mesh_; }  // Delaunay at the current points
  double energy() const { return lbfgs_.value(); }
  /// Entry k belongs to the mesh after k iterations; entry 0 to the start.
  const std::vector<double>& energy_history() const { return lbfgs_.value_history(); }  // Fig. 19
  const std::vector<double>& gradient_norm_history() const {
    return lbfgs_.gradient_norm_history();
  }
  int refusals() const { return refusals_; }  // trial points with a vertex outside

 private:
  LpOptimizer(const BoundaryMesh& boundary, const Fields& fields, const LpOptions& options,
              TriMesh mesh);
  Evaluation evaluate(std::span<const double> x, std::span<double> gradient);
  EvalStatus move_mesh(std::span<const Vec2> positions);
  EvalStatus rebuild(std::span<const Vec2> positions);
  bool all_inside(std::span<const Vec2> positions) const;
  void remember_hints();
  void set_move_limits();

  const BoundaryMesh* boundary_;
  const Fields* fields_;
  LpOptions options_;
  TriMesh mesh_;
  bool mesh_is_valid_ = true;  // false after an update that could not be finished
  EnergyWorkspace workspace_;
  UpdateWorkspace update_workspace_;
  std::vector<Index> hints_;  // #free  background triangles of the last accepted positions
  std::vector<Vec2> positions_, gradient_;
  Lbfgs lbfgs_;
  int refusals_ = 0;
};

}  // namespace lpq

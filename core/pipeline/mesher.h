// The order of the stages, and nothing else: fields, seeds, L_p, matching, clean-up,
// patches, smoothing, final check; other meshes to compare it with; with high effort patches,
// smoothing and check once more, annealing the best.
// A Mesher is a copyable value that advances in small steps; a batch run is a loop around it
// (mesh_domain.h).
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "base/result.h"
#include "domain/domain.h"
#include "lpcvt/restarts.h"
#include "mesh/output_mesh.h"
#include "patches/remesh.h"
#include "pipeline/attempts.h"
#include "pipeline/options.h"
#include "pipeline/prepare.h"
#include "pipeline/report.h"
#include "pipeline/trace.h"

namespace lpq {

enum class Stage { seeds, optimise, match, clean, patch, smooth, check, compare, done };
const char* stage_name(Stage stage);

class Mesher {
 public:
  /// Judges the input, makes the 1D mesh and both fields.
  /// Errors: those of make_domain, sample_boundary, make_fields; bad_option; too_many_elements.
  static Result<Mesher> start(const DomainInput& input, const Options& options = {},
                              const UserFields& user = {});

  /// Advances by one stage, or inside the long ones by a bounded piece of work: `iterations`
  /// iterations of L_p, a few patches, some iterations of smoothing. A mesh to compare with is made
  /// in one step. After the call stage() is what comes next. Errors: no_valid_mesh,
  /// too_many_elements, those of triangulate().
  Result<Stage> step(int iterations = 1);

  Stage stage() const { return stage_; }
  const Options& options() const { return options_; }
  const Report& report() const { return report_; }
  int iterations() const { return optimizer_ ? optimizer_->iterations() : 0; }  // of L_p, so far
  int max_iterations() const {
    return optimizer_ ? optimizer_->max_iterations() : attempt().iterations;
  }
  double energy() const { return optimizer_ ? optimizer_->energy() : 0; }
  double gradient_norm() const;  // of the energy, now
  const UnitFrame& frame() const;
  const Fields& fields() const;
  const BoundaryMesh& boundary() const;
  const TriMesh& triangles() const { return triangles_; }  // current triangulation
  const QuadMesh& quads() const { return quads_; }         // current quads, once matched
  const OutputMesh& output() const { return output_; }     // once done
  /// Other quads on the same nodes, in the caller's units and numbering like output().
  OutputMesh output_of(const QuadMesh& quads) const;

  /// From now on the stages leave their intermediate values in the trace. It never changes a
  /// result.
  void keep_trace();
  const Trace* trace() const { return trace_ ? &*trace_ : nullptr; }

  /// Once done, instead of copies: each leaves nothing behind.
  OutputMesh take_output() { return std::move(output_); }
  Report take_report() { return std::move(report_); }
  Trace take_trace() { return std::move(*trace_); }

 private:
  struct Candidate {
    QuadMesh quads;
    OutputMesh output;
    Report report;
    // of the attempt that made it
    std::shared_ptr<const Fields> fields;
    Index triangles_left = 0;
    bool gave_up = false;
    std::size_t attempt = 0;
    // once there is something to compare with
    TriMesh triangles = {};
    std::optional<Trace> trace = {};
  };

  const Attempt& attempt() const { return attempts_[attempt_]; }
  Result<Stage> make_seeds();
  Result<std::vector<Vec2>> choose_seeds() const;
  Result<Stage> lay_grid();
  void optimise(int iterations);
  void match();
  void clean();
  void remesh_patches();
  bool begin_annealing();
  void smooth();
  bool for_shape() const { return options_.method == Method::best; }
  int smoothing() const;
  Result<Stage> check();
  Index triangles_allowed() const;
  Result<Stage> next_attempt(const Error& failure);
  Stage begin_attempt();
  Result<Stage> compare();
  void keep_better(Candidate candidate);
  bool lags_behind() const;
  Stage go_on();
  void come_back();
  void show_kept();
  Stage take_kept();

  std::shared_ptr<const Preparation> prepared_;
  std::shared_ptr<const Fields> fields_;  // of the current attempt
  Options options_;
  Stage stage_ = Stage::seeds;
  std::vector<Attempt> attempts_;
  std::size_t attempt_ = 0;
  std::optional<LpRestarts> optimizer_;
  std::vector<Vec2> seeds_;
  TriMesh triangles_;
  QuadMesh quads_;
  std::optional<PatchRemesher> patches_;
  bool comparing_ = false;    // within one step
  Index triangles_left_ = 0;  // by the matching, of an attempt
  bool annealing_ = false;    // the second round of patches, smoothing and check
  bool gave_up_ = false;      // patches hardly ever helped in the first
  int smoothed_ = 0;          // iterations so far
  OutputMesh output_;
  Report report_;
  std::optional<Candidate> kept_;
  Problem first_failure_;  // of the chain that was asked for
  std::optional<Trace> trace_;
};

}  // namespace lpq

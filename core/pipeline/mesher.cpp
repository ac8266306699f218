#include "pipeline/mesher.h"

#include <algorithm>

#include "cleanup/cleanup.h"
#include "cleanup/smooth.h"
#include "cleanup/untangle.h"
#include "delaunay/delaunay.h"
#include "grids/submapped_grid.h"
#include "lpcvt/seeds.h"
#include "pipeline/finish.h"
#include "pipeline/shape_options.h"
#include "pipeline/stage_timer.h"
#include "recombine/recombine.h"
#include "recombine/subdivide.h"

namespace lpq {
namespace {

// Final smoothing when the caller leaves the choice to us, and its iterations per step.
constexpr int paper_smoothing = 100, best_smoothing = 300, long_smoothing = 600;
constexpr int smoothing_block = 100;
constexpr double least_gain = 2e-4;  // of mean eta, that another block is worth
constexpr int seeds_per_step = 50;

AttemptGrounds grounds_of(const Preparation& prepared) {
  return {.seeds_given = !prepared.seeds.empty(),
          .quads = prepared.own_fields ? cell_capacity(prepared.fields) : 0};
}

}  // namespace

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::seeds: return "seeds";
    case Stage::optimise: return "optimise";
    case Stage::match: return "match";
    case Stage::clean: return "clean";
    case Stage::patch: return "patch";
    case Stage::smooth: return "smooth";
    case Stage::check: return "check";
    case Stage::compare: return "compare";
    case Stage::done: return "done";
  }
  return "";
}

Result<Mesher> Mesher::start(const DomainInput& input, const Options& options,
                             const UserFields& user) {
  Mesher mesher;
  mesher.options_ = options;
  {
    const StageTimer timer(mesher.report_.times, "prepare");
    auto prepared = prepare(input, options, user);
    if (!prepared) return prepared.error();
    mesher.prepared_ = std::make_shared<const Preparation>(std::move(*prepared));
  }
  const Preparation& p = *mesher.prepared_;
  Report& report = mesher.report_;
  report.boundary_nodes = static_cast<Index>(p.boundary.points.size());
  report.boundary_edges = static_cast<Index>(p.boundary.edges.size());
  report.singularities = p.fields.singularities;
  report.simplify_deviation = p.domain.frame.length_to_world(p.boundary.simplify_deviation);
  report.warnings = p.domain.warnings;
  report.warnings.insert(report.warnings.end(), p.boundary.warnings.begin(),
                         p.boundary.warnings.end());
  mesher.fields_ = {mesher.prepared_, &p.fields};
  mesher.attempts_ = plan_attempts(options, grounds_of(p));
  return mesher;
}

// Where the energy of the start is not finite, there is none.
double Mesher::gradient_norm() const {
  if (!optimizer_ || optimizer_->gradient_norm_history().empty()) return 0;
  return optimizer_->gradient_norm_history().back();
}

const UnitFrame& Mesher::frame() const { return prepared_->domain.frame; }
const Fields& Mesher::fields() const { return *fields_; }
const BoundaryMesh& Mesher::boundary() const { return prepared_->boundary; }

void Mesher::keep_trace() {
  trace_.emplace();
  trace_->frame = frame();
  trace_->norm = options_.norm;
  trace_->fields = std::shared_ptr<const Fields>(prepared_, &prepared_->fields);
}

Result<Stage> Mesher::step(int iterations) {
  switch (stage_) {
    case Stage::seeds: return make_seeds();
    case Stage::optimise: optimise(iterations); break;
    case Stage::match: match(); break;
    case Stage::clean: clean(); break;
    case Stage::patch: remesh_patches(); break;
    case Stage::smooth: smooth(); break;
    case Stage::check: return check();
    case Stage::compare: return compare();
    case Stage::done: break;
  }
  return stage_;
}

Result<Stage> Mesher::make_seeds() {
  const StageTimer timer(report_.times, "seeds");
  report_ = without_attempt(std::move(report_));
  const BoundaryMesh& nodes = boundary();
  fields_ = attempt().size_factor == 1
                ? std::shared_ptr<const Fields>(prepared_, &prepared_->fields)
                : std::make_shared<const Fields>(
                      with_scaled_size(prepared_->fields, attempt().size_factor));
  if (attempt().grid != Grid::no) return lay_grid();
  auto chosen = choose_seeds();
  if (!chosen) {
    // What is asked for is too much; a smaller size may be, where it is not.
    if (attempt_ == 0) return chosen.error();
    return next_attempt(chosen.error());
  }
  seeds_ = std::move(*chosen);
  report_.seeds = static_cast<Index>(seeds_.size());
  report_.expected_seeds = expected_interior_points(nodes, *fields_);
  report_.chain = start_name(attempt());
  if (trace_) trace_->seeds = seeds_;

  if (attempt().iterations > 0) {
    LpOptions lp;
    lp.energy.p = options_.norm;
    lp.max_iterations = attempt().iterations;
    auto optimizer = LpRestarts::start(nodes, *fields_, seeds_, lp, {.rounds = attempt().restarts});
    if (!optimizer) return next_attempt(in_world(optimizer.error(), frame()));
    optimizer_ = std::move(*optimizer);
    triangles_ = optimizer_->mesh();
    stage_ = Stage::optimise;
    report_.chain += attempt().restarts > 0 ? " + L_p with restarts" : " + L_p";
  } else {
    auto triangles = triangulate(nodes, seeds_);
    if (!triangles) return next_attempt(in_world(triangles.error(), frame()));
    triangles_ = std::move(*triangles);
    stage_ = Stage::match;
  }
  if (trace_) trace_->start = triangles_;
  return stage_;
}

// On the nodes of the boundary, after a chain: its triangles say where holes lie.
Result<Stage> Mesher::lay_grid() {
  const double wanted = cell_capacity(*fields_);
  auto grid = attempt().grid == Grid::plane ? submapped_grid(boundary(), triangles_, wanted)
                                            : ring_grid(boundary(), triangles_, wanted);
  if (!grid || !invalid_faces(*grid).empty()) return go_on();
  quads_ = std::move(*grid);
  if (trace_) trace_->quads.push_back({"grid", quads_});
  triangles_left_ = 0;
  annealing_ = false;
  gave_up_ = true;
  smoothed_ = 0;
  report_.chain = start_name(attempt());
  return stage_ = Stage::smooth;
}

Result<std::vector<Vec2>> Mesher::choose_seeds() const {
  if (attempt().given) return given_seeds(boundary(), *fields_, prepared_->seeds);
  SeedOptions options;
  options.seed = options_.seed;
  options.max_points = options_.max_elements;
  std::vector<Vec2> seeds = attempt().seeds == Seeds::isotropic
                                ? isotropic_seeds(boundary(), *fields_, options)
                                : aligned_seeds(boundary(), *fields_, options);
  if (static_cast<Index>(seeds.size()) < options_.max_elements) return seeds;
  return Error{ErrorCode::too_many_elements,
               "The graded size field asks for more than " + std::to_string(options_.max_elements) +
                   " elements. Use a larger size or growth, or raise maxElements.",
               {}};
}

void Mesher::optimise(int iterations) {
  const StageTimer timer(report_.times, "optimise");
  const LpStatus status = optimizer_->step(iterations);
  triangles_ = optimizer_->mesh();
  if (status == LpStatus::running) return;
  report_.lp_status = status;
  report_.lp_rounds = optimizer_->rounds();
  report_.energy_history = optimizer_->energy_history();
  report_.gradient_norm_history = optimizer_->gradient_norm_history();
  optimizer_.reset();
  stage_ = Stage::match;
}

void Mesher::match() {
  const StageTimer timer(report_.times, "match");
  report_.tau = tau(triangles_);
  stage_ = Stage::clean;
  if (trace_) keep_triangles(*trace_, triangles_, *fields_);
  if (attempt().subdivide) {
    quads_ = subdivide_triangles(triangles_, boundary(), frame());
    triangles_left_ = 0;
    report_.chain += " + subdivision";
    return;
  }
  RecombineOptions recombine_options;
  recombine_options.all_quads = options_.elements != Elements::quad_dominant;
  recombine_options.keep_matching = trace_.has_value();
  if (options_.method == Method::paper) recombine_options.alignment_weight = 0;
  RecombineResult result = recombine(triangles_, *fields_, recombine_options);
  quads_ = std::move(result.mesh);
  triangles_left_ = result.triangles;
  report_.extra_edges = result.extra_edges;
  report_.matching_cost = result.cost;
  report_.chain += " + matching";
  if (!trace_) return;
  trace_->matched_triangles = std::move(result.triangulation);
  trace_->graph = std::move(result.graph);
  trace_->matching = std::move(result.matching);
  trace_->quads.push_back({"matched", quads_});
}

int Mesher::smoothing() const {
  if (options_.smoothing >= 0) return options_.smoothing;
  if (!for_shape()) return paper_smoothing;
  return annealing_ ? long_smoothing : best_smoothing;
}

void Mesher::clean() {
  const StageTimer timer(report_.times, "clean");
  CleanupOptions cleanup;
  if (for_shape()) {
    cleanup = cleanup_before_patches(options_);
  } else {
    // The paper's chain ends in a smoothing of positions only. Deviation: of eta, not Laplacian
    // (mean eta 0.93 against 0.89 on the benchmark domains).
    cleanup.topology = attempt_ > 0;
    cleanup.smoothing_iterations = smoothing();
  }
  cleanup.cut_darts = attempt().cut_darts;
  annealing_ = gave_up_ = false;
  CleanupResult result = clean_up(std::move(quads_), *fields_, cleanup);
  quads_ = std::move(result.mesh);
  if (trace_) trace_->quads.push_back({"cleaned", quads_});
  report_.chain += " + clean-up";
  stage_ = Stage::check;
  if (!for_shape() || result.stats.still_invalid > 0) return;
  patches_.emplace(quads_, *fields_, patch_options(options_));
  stage_ = Stage::patch;
}

void Mesher::remesh_patches() {
  const StageTimer timer(report_.times, "patch");
  const bool more = patches_->step(seeds_per_step);
  if (!more || trace_) quads_ = patches_->mesh();  // who looks on sees the patches come
  if (more) return;
  // Where patches do not help, a block of smoothing does what can be done.
  gave_up_ = patches_->gave_up();
  smoothed_ = gave_up_ ? std::max(0, smoothing() - smoothing_block) : 0;
  patches_.reset();
  if (trace_) trace_->quads.push_back({annealing_ ? "annealed" : "patched", quads_});
  report_.chain += annealing_ ? " + annealing" : " + patches";
  stage_ = Stage::smooth;
}

void Mesher::smooth() {
  const StageTimer timer(report_.times, "smooth");
  const int steps = std::min(smoothing_block, smoothing() - smoothed_);
  SmoothOptions options = shape_smoothing(options_);
  options.iterations = steps;
  options.rounding = smoothed_ == 0 ? coarse_rounding : fine_rounding;
  options.lift = smoothed_ == 0;
  const double before = quad_quality(quads_).eta_mean;
  smooth_eta(quads_, *fields_, options);
  smoothed_ += steps;
  const bool converged =
      smoothed_ > smoothing_block && quad_quality(quads_).eta_mean - before < least_gain;
  if (smoothed_ < smoothing() && !converged) {
    if (attempt().alternative && !annealing_ && lags_behind()) go_on();
    return;
  }
  if (trace_) trace_->quads.push_back({"smoothed", quads_});
  report_.chain += " + smoothing";
  stage_ = Stage::check;
}

OutputMesh Mesher::output_of(const QuadMesh& quads) const {
  return to_output(quads, prepared_->domain, boundary());
}

}  // namespace lpq

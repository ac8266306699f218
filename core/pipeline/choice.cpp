// Mesher: which of the meshes that attempts make is kept, and what comes after each.
#include <algorithm>
#include <utility>

#include "field/size_for_count.h"
#include "pipeline/finish.h"
#include "pipeline/mesher.h"
#include "pipeline/shape_options.h"
#include "pipeline/stage_timer.h"
#include "recombine/subdivide.h"

namespace lpq {
namespace {

// With less than that no other mesh is looked for.
constexpr double low_cost = 0.012;
// At least this share of it is left by all iterations of smoothing but the first.
constexpr double least_left = 0.75;
// Of a number of quads that is asked for: a tenth more or less counts as 0.02 of mean eta.
constexpr double count_weight = 0.2;

/// By how much the larger of the two exceeds the other.
double off_count(Index quads, int wanted) {
  if (quads == 0) return 1;
  const double ratio = static_cast<double>(quads) / wanted;
  return std::max(ratio, 1 / ratio) - 1;
}

/// What is lacking in shape, regular vertices and size: less is better. One irregular vertex in a
/// hundred counts as much as 0.01 of mean eta.
double cost_of(const Report& report, const Options& options) {
  const QuadQuality& quality = report.quality;
  return 1 - quality.eta_mean + 0.01 * (100 - quality.four_valent_percent) +
         std::max(0.0, least_eta - quality.eta_min) + options.size_weight * report.size.off +
         (options.quads > 0 ? count_weight * off_count(quality.quads, options.quads) : 0);
}

/// Fewer triangles come first, but where they may stay.
bool is_better(const Report& a, const Report& b, const Options& options) {
  if (options.elements != Elements::quad_dominant && a.quality.triangles != b.quality.triangles)
    return a.quality.triangles < b.quality.triangles;
  return cost_of(a, options) < cost_of(b, options);
}

Warning another_chain(const Error& failure) {
  return {ErrorCode::adapted,
          "What is tried first did not pass the final check here. This mesh was made in another "
          "way, and may be poorer.",
          failure.where};
}

}  // namespace

Result<Stage> Mesher::check() {
  const StageTimer timer(report_.times, "check");
  const BoundaryMesh& nodes = boundary();
  output_ = to_output(quads_, prepared_->domain,
                      attempt().subdivide ? halve_edges(nodes, frame()) : nodes);
  if (const std::vector<Violation> violations = check_output(output_); !violations.empty())
    return next_attempt(no_valid_mesh(output_, violations));

  report_.quality = quad_quality(quads_);
  if (const Index surplus = report_.quality.triangles - triangles_allowed(); surplus > 0)
    return next_attempt({ErrorCode::no_valid_mesh,
                         std::to_string(surplus) + " triangles could not be paired into quads.",
                         {}});
  report_.interior_vertices = static_cast<Index>(output_.points.size()) - output_.fixed;
  report_.size = size_fidelity(quads_, prepared_->fields);
  report_.hash = output_hash(output_);
  keep_better({quads_, output_, report_, fields_, triangles_left_, gave_up_, attempt_});
  return go_on();
}

// The matching leaves one in every part of odd count; later steps neither need nor make others.
Index Mesher::triangles_allowed() const {
  switch (options_.elements) {
    case Elements::quad: return 0;
    case Elements::one_triangle: return triangles_left_;
    case Elements::quad_dominant: break;
  }
  return report_.quality.triangles;
}

void Mesher::keep_better(Candidate candidate) {
  if (!kept_ || is_better(candidate.report, kept_->report, options_)) kept_ = std::move(candidate);
}

// A mesh that has been smoothed for a while and will not be the one that is kept.
bool Mesher::lags_behind() const {
  if (!kept_ || options_.elements == Elements::one_triangle) return false;  // fewer come first
  Report report;
  report.quality = quad_quality(quads_);
  report.size = size_fidelity(quads_, prepared_->fields);
  return least_left * cost_of(report, options_) > cost_of(kept_->report, options_);
}

// To the alternative that is left, or with what was kept; while there is nothing, to the next
// attempt.
Stage Mesher::go_on() {
  if (comparing_) return stage_ = Stage::done;
  if (kept_ && kept_->attempt != attempt_) come_back();
  const bool is_wanted =
      !kept_ || (attempt_ + 1 < attempts_.size() && attempts_[attempt_ + 1].alternative &&
                 cost_of(kept_->report, options_) > low_cost);
  if (!is_wanted) return begin_annealing() ? stage_ : take_kept();
  if (kept_) {
    kept_->triangles = triangles_;
    kept_->trace = trace_;
  }
  ++attempt_;
  return begin_attempt();
}

Stage Mesher::begin_attempt() {
  optimizer_.reset();
  patches_.reset();
  if (trace_ && kept_ && attempt().grid == Grid::no) keep_trace();  // of this chain alone
  return stage_ = attempt().at_once ? Stage::compare : Stage::seeds;
}

Result<Stage> Mesher::next_attempt(const Error& failure) {
  if (kept_) return go_on();  // the annealed mesh failed, or an alternative
  if (!first_failure_) first_failure_ = failure;
  if (!comparing_ && attempt_ + 1 == attempts_.size()) return *first_failure_;
  ++report_.attempts;
  return go_on();
}

// A whole attempt.
Result<Stage> Mesher::compare() {
  comparing_ = true;
  Result<Stage> stage = stage_ = Stage::seeds;
  while (stage && stage_ != Stage::done) stage = step();
  comparing_ = false;
  if (!stage) return stage;
  return go_on();
}

// High effort goes on from the mesh that normal effort ends with, and must end with a better one.
bool Mesher::begin_annealing() {
  if (!for_shape() || options_.effort == Effort::normal || annealing_ || kept_->gave_up)
    return false;
  show_kept();
  annealing_ = true;
  patches_.emplace(quads_, *fields_, annealing_options(options_));
  stage_ = Stage::patch;
  return true;
}

// From an alternative that was no better.
void Mesher::come_back() {
  triangles_ = kept_->triangles;
  trace_ = kept_->trace;
  show_kept();
}

void Mesher::show_kept() {
  quads_ = kept_->quads;
  output_ = kept_->output;
  fields_ = kept_->fields;
  triangles_left_ = kept_->triangles_left;
  const auto times = report_.times;
  report_ = kept_->report;
  report_.times = times;
}

Stage Mesher::take_kept() {
  if (trace_ && trace_->quads.back().mesh.points != kept_->quads.points)
    trace_->quads.push_back({"kept", kept_->quads});
  show_kept();
  const auto tell = [this](std::vector<Warning> warnings) {
    for (Warning& warning : warnings) report_.warnings.push_back(std::move(warning));
  };
  if (prepared_->seeks_count)
    if (const Problem off = judge_count(report_.quality.quads, options_.quads)) tell({*off});
  if (first_failure_) tell({another_chain(*first_failure_)});
  tell(tell_poor_quads(output_));
  if (options_.elements == Elements::one_triangle) tell(tell_triangles(output_));
  return stage_ = Stage::done;
}

}  // namespace lpq

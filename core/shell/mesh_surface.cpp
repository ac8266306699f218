// See mesh_surface.h.
#include "shell/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/share_out.h"
#include "base/words.h"
#include "field/size_for_count.h"
#include "geometry/box.h"
#include "numerics/elementary.h"
#include "pipeline/shape_options.h"
#include "pipeline/stage_timer.h"
#include "shell/check.h"
#include "shell/place.h"
#include "shell/rounds.h"
#include "surface/repair_warnings.h"
#include "surface/size_field.h"

namespace lpq {
namespace {

// Once the shape is made, only what lies in one place to the last digits, and so little that no
// shape is spoilt.
constexpr Parting at_the_end{.one_point = 2e-12, .inward = 1e-4};

constexpr double default_quads = 3000;
constexpr int most_threads = 4;  // for each that the machine runs at once

}  // namespace

class SurfaceMesher::Run {
 public:
  explicit Run(const SurfaceOptions& options) : options_(options) {}

  Problem start(SurfaceSoup soup) {
    if (Problem range = check_ranges(options_)) return range;
    if (Problem both = judge_size_options(options_)) return both;
    return repair(std::move(soup));
  }

  Problem step() {
    switch (stage_) {
      case SurfaceStage::features: return then(SurfaceStage::field, find_lines());
      case SurfaceStage::field: return then(SurfaceStage::charts, make_field());
      case SurfaceStage::charts: return then(SurfaceStage::mesh, make_atlas());
      case SurfaceStage::mesh: return mesh_more();
      case SurfaceStage::seams:
        return options_.method == Method::paper ? finish_paper() : finish_seams();
      case SurfaceStage::shape: return finish_shape();
      case SurfaceStage::done: break;
    }
    return std::nullopt;
  }

  bool mesh_planes(int threads, Monitor monitor) {
    if (stage_ != SurfaceStage::mesh) return true;
    const StageTimer timer = timed("mesh");
    const auto count = static_cast<int>(atlas().charts.size());
    return rounds_->mesh_planes(threads, [&](Index over) {
      return monitor(Progress{stage_name(stage_), over, count});
    });
  }

  SurfaceStage stage() const { return stage_; }
  const SurfaceOptions& options() const { return options_; }
  const SurfaceMesh& surface() const { return outcome_.surface; }
  const SurfaceFeatures& features() const { return features_; }
  std::span<const double> sizes() const {
    return rounds_ ? rounds_->size() : std::span<const double>(size_);
  }
  const SurfaceCrossField& cross_field() const { return cross_; }
  const Atlas& atlas() const { return outcome_.atlas; }
  Index charts_meshed() const {
    if (charts() != nullptr) return charts()->chart();
    return stage_ > SurfaceStage::mesh ? static_cast<Index>(outcome_.atlas.charts.size()) : 0;
  }
  /// Of the stage's work.
  double share() const {
    if (seams_) return seams_->share();
    if (shape_) return shape_->share();
    if (charts() == nullptr || outcome_.atlas.charts.empty()) return 0;
    return static_cast<double>(charts()->chart()) /
           static_cast<double>(outcome_.atlas.charts.size());
  }
  const ChartsMesher* charts() const { return rounds_ ? rounds_->charts() : nullptr; }
  const ShellMesh& mesh() const {
    return stage_ == SurfaceStage::mesh ? rounds_->mesh() : outcome_.mesh;
  }
  const ShellOutcome& outcome() const { return outcome_; }
  ShellOutcome take() { return std::move(outcome_); }

 private:
  StageTimer timed(const char* stage) { return {outcome_.report.times, stage}; }

  Problem then(SurfaceStage next, Problem failure) {
    if (!failure) stage_ = next;
    return failure;
  }

  Problem repair(SurfaceSoup soup) {
    const StageTimer timer = timed("repair");
    std::vector<Warning>& warnings = outcome_.report.warnings;
    warnings = std::move(soup.warnings);
    auto repaired = repair_surface(std::move(soup), {.weld = options_.weld});
    if (!repaired) return repaired.error();
    outcome_.surface = std::move(repaired->mesh);
    outcome_.group_names = std::move(repaired->group_names);
    asked_ = std::move(repaired->sizes);
    outcome_.body_names = std::move(repaired->body_names);
    outcome_.report.repair = repaired->report;
    for (Warning& warning : repair_warnings(repaired->report))
      warnings.push_back(std::move(warning));
    return std::nullopt;
  }

  Problem find_lines() {
    const StageTimer timer = timed("features");
    double& h = outcome_.report.target_size;
    h = options_.size > 0 ? options_.size : size_by_area();
    if (const double across = bounding_diagonal(surface().points); options_.size > across)
      outcome_.report.warnings.push_back(
          {ErrorCode::adapted,
           "The mesh size " + short_number(h) + " is larger than the whole surface, which is " +
               short_number(across) + " across; a smaller one was taken. Check the unit of length.",
           {}});
    if (auto failure = lines_and_sizes(h)) return failure;
    if (options_.quads > 0)
      if (auto failure = size_by_count(h)) return failure;
    const double quads = surface_capacity(surface(), size_);
    if (!(quads <= options_.max_elements)) return too_many_elements(quads, options_.max_elements);
    return std::nullopt;
  }

  Problem lines_and_sizes(double h) {
    const std::vector<double> plain(surface().points.size(), h);
    features_ = find_features(surface(), plain,
                              {.angle = options_.feature_angle, .groups = options_.keep_groups});
    feature_ = features_.half_edges();
    auto size = sizes_for(h);
    if (!size) return size.error();
    size_ = std::move(*size);
    return std::nullopt;
  }

  Result<std::vector<double>> sizes_for(double h) const {
    SurfaceSizeOptions sizes;
    sizes.size = h;
    sizes.at_vertices = asked_;
    sizes.largest_turn = options_.turn * pi / 180;
    sizes.growth = growth_of(options_);
    return surface_sizes(surface(), feature_, sizes);
  }

  /// The features are those of the size that the search begins with; then those of what it finds.
  Problem size_by_count(double& h) {
    const auto quads_of = [&](double size) -> Result<double> {
      const auto sizes = sizes_for(size);
      if (!sizes) return sizes.error();
      return surface_capacity(surface(), *sizes);
    };
    const auto found =
        size_for_count(h, bounding_diagonal(surface().points), options_.quads, quads_of);
    if (!found) return found.error();
    if (Problem poor = judge_count(found->quads, options_.quads))
      outcome_.report.warnings.push_back(std::move(*poor));
    if (found->size == h) return std::nullopt;
    h = found->size;
    return lines_and_sizes(h);
  }

  /// Of needles the border asks for more than the area.
  double size_by_area() const {
    const double quads = options_.quads > 0 ? options_.quads : default_quads;
    double area = 0, border = 0;
    for (Index t = 0; t < surface().triangle_count(); ++t) area += triangle_area(surface(), t);
    for (Index e = 0; e < 3 * surface().triangle_count(); ++e)
      if (surface().twins[e] == none)
        border +=
            distance(surface().points[surface().origin(e)], surface().points[surface().target(e)]);
    return std::max(std::sqrt(area / quads), border / (2 * quads));
  }

  Problem make_field() {
    const StageTimer timer = timed("field");
    cross_ = solve_surface_cross(surface(), feature_);
    return std::nullopt;
  }

  Problem make_atlas() {
    const StageTimer timer = timed("charts");
    outcome_.atlas = make_charts(surface(), feature_);
    rounds_.emplace(Cut{surface(), features_, cross_, atlas()}, std::move(size_), options_);
    return std::nullopt;
  }

  Problem mesh_more() {
    const StageTimer timer = timed("mesh");
    if (auto error = rounds_->step()) return error;
    outcome_.report.rounds = rounds_->round();
    if (!rounds_->done()) return std::nullopt;
    outcome_.mesh = rounds_->mesh();
    stage_ = SurfaceStage::seams;
    return std::nullopt;
  }

  /// The paper's chain ends where the charts are lifted.
  Problem finish_paper() {
    improve(ShellMesh(outcome_.mesh));
    return sum_up();
  }

  Problem finish_seams() {
    const StageTimer timer = timed("seams");
    if (!seams_) {
      seams_.emplace(rounds_->charted(), window_options(options_), ShellMesh(outcome_.mesh));
      return std::nullopt;
    }
    if (seams_->step()) return std::nullopt;
    const SeamStats stats = seams_->stats();
    if (improve(seams_->take())) outcome_.report.seams = stats;
    seams_.reset();
    stage_ = SurfaceStage::shape;
    return std::nullopt;
  }

  Problem finish_shape() {
    {
      const StageTimer timer = timed("shape");
      if (!shape_) {
        shape_.emplace(rounds_->charted(), shape_options(), ShellMesh(outcome_.mesh));
        return std::nullopt;
      }
      if (shape_->step()) return std::nullopt;
      const ShapeStats stats = shape_->stats();
      if (improve(shape_->take(), at_the_end)) outcome_.report.shape = stats;
      shape_.reset();
    }
    return sum_up();
  }

  Problem sum_up() {
    const StageTimer timer = timed("summary");
    summarise(features_, cross_, sizes(), outcome_);
    stage_ = SurfaceStage::done;
    return std::nullopt;
  }

  /// The mesh of the charts is valid: one that is not does not take its place.
  bool improve(ShellMesh mesh, const Parting& parting = {}) {
    part_vertices(surface(), mesh, parting);
    const bool is_valid = check_shell(surface(), mesh, 1).empty();
    if (is_valid) outcome_.mesh = std::move(mesh);
    return is_valid;
  }

  SmoothOptions shape_options() const {
    SmoothOptions smoothing = shape_smoothing(chart_options(options_));
    // Sizes even out slowly: three times as many as in the plane.
    smoothing.iterations = options_.smoothing >= 0 ? options_.smoothing : 3 * smoothing.iterations;
    return smoothing;
  }

  SurfaceOptions options_;
  SurfaceStage stage_ = SurfaceStage::features;
  ShellOutcome outcome_;
  SurfaceFeatures features_;
  std::vector<char> feature_;  // #half-edges
  std::vector<double> asked_;  // #V or empty, by the caller; 0 = no size there
  std::vector<double> size_;   // #V  until the rounds take it
  SurfaceCrossField cross_;
  std::optional<ChartRounds> rounds_;   // from the stage `mesh` on
  std::optional<SeamFinisher> seams_;   // in their stage
  std::optional<ShapeFinisher> shape_;  // in its stage
};

SurfaceMesher::SurfaceMesher(std::unique_ptr<Run> run) : run_(std::move(run)) {}
SurfaceMesher::SurfaceMesher(SurfaceMesher&&) noexcept = default;
SurfaceMesher& SurfaceMesher::operator=(SurfaceMesher&&) noexcept = default;
SurfaceMesher::~SurfaceMesher() = default;

Result<SurfaceMesher> SurfaceMesher::start(SurfaceSoup soup, const SurfaceOptions& options) {
  auto run = std::make_unique<Run>(options);
  if (auto error = run->start(std::move(soup))) return *error;
  return SurfaceMesher(std::move(run));
}

Result<SurfaceStage> SurfaceMesher::step() {
  if (auto error = run_->step()) return *error;
  return run_->stage();
}

bool SurfaceMesher::mesh_planes(int threads, Monitor monitor) {
  return run_->mesh_planes(threads, monitor);
}

SurfaceStage SurfaceMesher::stage() const { return run_->stage(); }
const SurfaceOptions& SurfaceMesher::options() const { return run_->options(); }
const SurfaceMesh& SurfaceMesher::surface() const { return run_->surface(); }
const SurfaceFeatures& SurfaceMesher::features() const { return run_->features(); }
std::span<const double> SurfaceMesher::sizes() const { return run_->sizes(); }
const SurfaceCrossField& SurfaceMesher::cross_field() const { return run_->cross_field(); }
const Atlas& SurfaceMesher::atlas() const { return run_->atlas(); }
Index SurfaceMesher::charts_meshed() const { return run_->charts_meshed(); }
double SurfaceMesher::share() const { return run_->share(); }
const ChartsMesher* SurfaceMesher::charts() const { return run_->charts(); }
const ShellMesh& SurfaceMesher::mesh() const { return run_->mesh(); }
const ShellOutcome& SurfaceMesher::outcome() const { return run_->outcome(); }
ShellOutcome SurfaceMesher::take() { return run_->take(); }

const char* stage_name(SurfaceStage stage) {
  constexpr const char* names[] = {"features", "field", "charts", "mesh", "seams", "shape", "done"};
  return names[static_cast<std::size_t>(stage)];
}

namespace {

Progress progress_of(const SurfaceMesher& mesher) {
  constexpr int whole = 100;
  if (mesher.stage() > SurfaceStage::mesh)
    return {stage_name(mesher.stage()), static_cast<int>(whole * mesher.share()), whole};
  return {stage_name(mesher.stage()), mesher.charts_meshed(),
          static_cast<int>(mesher.atlas().charts.size())};
}

}  // namespace

Result<ShellOutcome> mesh_surface(SurfaceSoup soup, const SurfaceOptions& options, Monitor monitor,
                                  int threads) {
  threads = threads <= 0 ? machine_threads() : std::min(threads, most_threads * machine_threads());
  const Error cancelled{ErrorCode::cancelled, "The run was cancelled.", {}};
  auto mesher = SurfaceMesher::start(std::move(soup), options);
  if (!mesher) return mesher.error();
  while (mesher->stage() != SurfaceStage::done) {
    if (!monitor(progress_of(*mesher))) return cancelled;
    if (threads > 1 && !mesher->mesh_planes(threads, monitor)) return cancelled;
    if (const auto stage = mesher->step(); !stage) return stage.error();
  }
  return mesher->take();
}

}  // namespace lpq

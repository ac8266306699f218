// See chart_run.h.
#include "shell/chart_run.h"

#include <algorithm>
#include <utility>

#include "base/hash.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/smooth.h"
#include "grids/border_loops.h"
#include "grids/submapped_grid.h"
#include "mesh/quality.h"
#include "numerics/elementary.h"
#include "pipeline/attempts.h"
#include "pipeline/shape_options.h"
#include "shell/border_slide.h"
#include "shell/chart_fields.h"
#include "surface/charts/carry.h"

namespace lpq {
namespace {

// Sizes on a surface vary over lengths of some quads.
constexpr double fields_detail = 4;
// Of a plane that is as good as the surface; and of one where corners of quads are as on it.
constexpr double most_unevenness = 0.02 * 0.02, most_askew = 0.15 * 0.15;

/// How fine the fields of the plane must be, from place to place: a chart may have a size far below
/// all others in one spot.
std::vector<DomainInput::SizeAt> detail_of(const Fields& fields) {
  std::vector<DomainInput::SizeAt> detail;
  for (std::size_t v = 0; v < fields.h.size(); ++v)
    detail.push_back({fields.background.points[v], fields_detail * fields.h[v]});
  return detail;
}

/// Sizes of a chart as the caller's own, times a factor; they refer to `fields`.
UserFields sizes_of_user(const Fields& fields, double factor = 1) {
  UserFields user;
  Index hint = none;
  user.size = [&fields, hint, factor](Vec2 p) mutable { return factor * fields.size(p, hint); };
  user.sizes = detail_of(fields);
  user.detail = fields_detail * *std::max_element(fields.h.begin(), fields.h.end());
  return user;
}

/// And directions, and what they are measured after.
UserFields fields_of_user(const Fields& fields) {
  UserFields user = sizes_of_user(fields);
  Index hint = none;
  user.angle = [&fields, hint](Vec2 p) mutable {
    const Vec2 axis = fields.sample(p, hint).axis;
    return arc_tangent(axis.y, axis.x);
  };
  if (!fields.stretch.empty())
    user.stretch = [&fields, hint](Vec2 p) mutable { return fields.stretch_at(p, hint); };
  return user;
}

/// How far the map is from one that keeps angles, and from one that keeps lengths but for a common
/// factor: variances.
struct Unevenness {
  double angle = 0, length = 0;
};

Unevenness unevenness_of(const SurfaceMesh& mesh, const Chart& chart) {
  const std::vector<Vec2> mu = stretches_in_plane(mesh, chart);
  double area = 0, stretch = 0, scale = 0, square = 0;
  for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
    const auto [a, b, c] = chart.plane.triangles[t];
    const std::vector<Vec2>& p = chart.plane.points;
    const double weight = 0.5 * cross(p[b] - p[a], p[c] - p[a]);
    area += weight;
    stretch += weight * squared_length(mu[t]);
    scale += weight * chart.scale[t];
    square += weight * chart.scale[t] * chart.scale[t];
  }
  return {stretch / area, square * area / (scale * scale) - 1};
}

bool is_whole_face(const Charted& charted, const Chart& chart) {
  return std::all_of(chart.borders.values.begin(), chart.borders.values.end(),
                     [&](Index e) { return charted.features.half_edge_is_feature(e); });
}

std::uint64_t fingerprint(Index chart, const DomainInput& input, const Fields& fields) {
  Fnv1a hash;
  const auto add = [&hash](const Loop& line) {
    const auto size = static_cast<Index>(line.size());
    hash.add(std::span<const Index>(&size, 1));
    hash.add(std::span<const Vec2>(line));
  };
  hash.add(std::span<const Index>(&chart, 1));
  for (const Loop& loop : input.regions[0].loops) add(loop);
  for (const auto& line : input.polylines) add(line.points);
  for (const auto& point : input.points) hash.add(std::span<const Vec2>(&point.position, 1));
  hash.add(std::span<const double>(fields.h));
  return hash.value();
}

/// Of a grid: at the border nodes slide later to where its lines end. Where all quads lie there, as
/// in a strip one quad wide, that mends some of them, but not a grid that leans as a whole.
double least_eta_inside(const QuadMesh& grid) {
  double least = 1;
  bool all_touch = true;
  for (const Face& face : grid.faces) {
    if (touches_border(grid, face)) continue;
    all_touch = false;
    least = std::min(least, face_eta(grid.points, face));
  }
  return all_touch ? quad_quality(grid).eta_mean : least;
}

/// What is lacking in shape, and in regular vertices: one for each vertex counts as much as eta 0.
MeshCost cost_of(const QuadMesh& quads, double eta_min) {
  const QuadTopology topology{QuadMesh(quads)};
  MeshCost cost;
  cost.irregularity = IdealValence(topology).total_weight(topology);
  cost.whole = 1 - quad_quality(quads).eta_mean + std::max(0.0, least_eta - eta_min) +
               cost.irregularity / static_cast<double>(topology.vertex_count());
  return cost;
}

/// In smaller faces other sizes have nothing to gain.
constexpr double fewest_quads = 50;

/// Of the first try with a field of its own, and of those after it.
double size_factor_of(std::size_t tries) { return tries == 1 ? 1 : other_sizes[tries - 2]; }

}  // namespace

ChartRun::ChartRun(const Charted& charted, const CurveNodes& nodes, Index chart)
    : chart_(charted.atlas.charts[chart]),
      domain_(
          chart_domain(charted.mesh, charted.lines, charted.curves, charted.atlas, chart_, nodes)),
      fields_(chart_fields(charted.mesh, charted.cross, charted.size, chart_)),
      key_(fingerprint(chart, domain_.input, fields_)),
      whole_face_(is_whole_face(charted, chart_)) {
  const Unevenness off = unevenness_of(charted.mesh, chart_);
  conformal_ = off.angle < most_askew;
  isometric_ = off.angle < most_unevenness && off.length < most_unevenness;
}

std::optional<Result<OutputMesh>> ChartRun::step(const Options& options) {
  const Problem failure = advance(options);
  const bool is_made = !failure && mesher_->stage() == Stage::done;
  if (!failure && !is_made && !repeats_a_try()) return std::nullopt;
  if (failure) failure_ = failure;
  if (is_made) {
    const QuadMesh& quads = mesher_->quads();
    keep_better(quads, quad_quality(quads).eta_min, mesher_->output());
  }
  if (begin_again(options)) return std::nullopt;
  if (best_) return Result<OutputMesh>(std::move(*best_));
  return Result<OutputMesh>(std::move(*failure_));
}

Problem ChartRun::advance(const Options& options) {
  if (!mesher_) {
    auto mesher = Mesher::start(
        domain_.input, options,
        tries_ == 0 ? fields_of_user(fields_) : sizes_of_user(fields_, size_factor_of(tries_)));
    if (!mesher) return mesher.error();
    mesher_ = std::move(*mesher);
  }
  const auto stage = mesher_->step();
  return stage ? std::nullopt : std::optional(stage.error());
}

/// Is it about to clean up the same quads as another try? Without room for vertices inside the
/// fields decide nothing.
bool ChartRun::repeats_a_try() {
  if (is_matched_ || mesher_->stage() != Stage::clean) return false;
  is_matched_ = true;
  const QuadMesh& quads = mesher_->quads();
  Fnv1a hash;
  hash.add(std::span<const Vec2>(quads.points));
  hash.add(std::span<const Face>(quads.faces));
  if (std::find(matched_.begin(), matched_.end(), hash.value()) != matched_.end()) return true;
  matched_.push_back(hash.value());
  return false;
}

bool ChartRun::keep_better(const QuadMesh& quads, double eta_min, OutputMesh output) {
  const MeshCost cost = cost_of(quads, eta_min);
  if (best_ && !(cost.whole < cost_.whole)) return false;
  best_ = std::move(output);
  cost_ = cost;
  return true;
}

/// If that is better.
bool ChartRun::take(std::optional<QuadMesh> grid, const Options& options) {
  if (!grid || !is_convex_after_sliding(*grid, border_loops(mesher_->boundary()))) return false;
  smooth_eta(*grid, mesher_->fields(), shape_smoothing(options));
  return keep_better(*grid, least_eta_inside(*grid), mesher_->output_of(*grid));
}

/// Plain grids where the border allows them.
bool ChartRun::take_grids(const Options& options) {
  const BoundaryMesh& boundary = mesher_->boundary();
  const double wanted = cell_capacity(mesher_->fields());
  const bool plane =
      isometric_ && take(submapped_grid(boundary, mesher_->triangles(), wanted), options);
  const bool ring = take(ring_grid(boundary, mesher_->triangles(), wanted), options);
  return plane || ring;
}

/// Is there hope for a better mesh?
bool ChartRun::may_gain(bool took_grid) const {
  if (tries_ == 0) return !took_grid || cost_.irregularity > 0;
  const double quads = cell_capacity(fields_);
  return tries_ <= other_sizes.size() && quads > fewest_quads && quads < few_quads &&
         !(best_ && cost_.irregularity == 0);
}

bool ChartRun::begin_again(const Options& options) {
  if (!conformal_ || options.method == Method::paper) return false;
  const bool took_grid = tries_ == 0 && mesher_ && take_grids(options);
  if (!isometric_ || !whole_face_ || !may_gain(took_grid)) return false;
  ++tries_;
  is_matched_ = false;
  mesher_.reset();
  return true;
}

}  // namespace lpq

// See rounds.h.
#include "shell/rounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sort_unique.h"
#include "base/words.h"
#include "geometry/box.h"
#include "shell/check.h"
#include "shell/crossings.h"
#include "shell/place.h"
#include "shell/topology.h"
#include "surface/corners.h"
#include "surface/size_field.h"
#include "surface/tips.h"

namespace lpq {
namespace {

constexpr double default_growth = 0.3;
// Sizes become smaller near the faults alone at first.
constexpr Index most_rounds = 12, local_rounds = 3;
// A mesh that is only too coarse in places is good enough after so many, or where smaller sizes
// have had faults in so many.
constexpr int most_doubts = 2, most_faulty = 3;
// Of the crossings for the size, or of the places that are too coarse: else smaller sizes do not
// help.
constexpr double most_left = 0.8;
// Room for more quads than at first by so much: smaller sizes are not what the surface lacks.
constexpr double most_growth = 8, some_quads = 2000;
constexpr double one_point = 1e-12;  // of the diagonal
// That a round looks at. Of faults nearly all: a thousand may be along one tube of hundreds.
constexpr std::size_t most_faults = 100'000, most_doubtful = 30;

SurfaceFeatures features_and_cuts(const Cut& cut) {
  SurfaceFeatures lines = cut.features;
  for (std::size_t e = 0; e < cut.atlas.cut.size(); ++e) {
    FeatureKind& kind = lines.kind[lines.edges.edge_of[e]];
    if (cut.atlas.cut[e] && kind == FeatureKind::smooth) kind = FeatureKind::marked;
  }
  // Features may divide a chart: what lies between lines needs an even border each.
  number_faces(cut.surface, lines);
  return lines;
}

}  // namespace

double growth_of(const SurfaceOptions& options) {
  return options.growth > 0 ? options.growth : default_growth;
}

ChartRounds::ChartRounds(const Cut& cut, std::vector<double> size, const SurfaceOptions& options)
    : cut_(cut),
      options_(options),
      lines_(features_and_cuts(cut)),
      size_(std::move(size)),
      capacity_at_first_(surface_capacity(cut.surface, size_)),
      kept_vertices_(cut.surface.points.size(), 0) {}

ChartRounds::~ChartRounds() = default;

Charted ChartRounds::charted() const {
  return {cut_.surface, cut_.features, cut_.cross, size_, cut_.atlas, lines_, curves_, nodes_};
}

bool ChartRounds::mesh_planes(int threads, FunctionRef<bool(Index)> keep_going) {
  return !charts_ || charts_->chart() > 0 || charts_->mesh_planes(threads, keep_going);
}

Problem ChartRounds::step() {
  if (!charts_) {
    auto problem = start_round();
    return problem && take_kept() ? std::nullopt : problem;
  }
  charts_->step();
  if (!charts_->done()) return std::nullopt;
  MeshedCharts made = charts_->take();
  charts_.reset();
  return end_round(std::move(made));
}

Problem ChartRounds::start_round() {
  mark_corners(cut_.surface, size_, FeatureOptions{}.corner_angle, lines_);
  for (std::size_t v = 0; v < lines_.corner.size(); ++v)
    lines_.corner[v] = lines_.corner[v] || cut_.features.corner[v] || kept_vertices_[v];
  curves_ = trace_curves(cut_.surface, lines_);
  auto nodes = mesh_curves(cut_.surface, lines_, curves_, size_);
  if (!nodes) return nodes.error();
  nodes_ = std::move(*nodes);
  if (round_ == 1) nodes_at_first_ = static_cast<double>(nodes_.points.size());
  // A quad has four corners.
  if (static_cast<double>(nodes_.points.size()) > 4.0 * options_.max_elements)
    return Error{ErrorCode::too_many_elements,
                 "The curves of the surface alone need " + std::to_string(nodes_.points.size()) +
                     " nodes, too many for " + std::to_string(options_.max_elements) +
                     " elements. Use a larger size or raise maxElements.",
                 {}};
  charts_.emplace(charted(), chart_options(options_), made_);
  return std::nullopt;
}

Problem ChartRounds::end_round(MeshedCharts made) {
  mesh_ = std::move(made.mesh);
  std::vector<Fault> faults = faults_of(made.failures);
  if (faults.empty()) faults = faults_at(check_shell(cut_.surface, mesh_, most_faults));
  if (!faults.empty()) {
    faulty_ += kept_.has_value();
    return try_again(faults);
  }
  done_ = true;
  refine_doubts();
  return std::nullopt;
}

/// Another round where the mesh is too coarse, with this one kept: for as long as that helps.
void ChartRounds::refine_doubts() {
  auto doubts = faults_at(check_places(mesh_.points, mesh_.faces,
                                       one_point * bounding_diagonal(cut_.surface.points),
                                       most_doubtful, bodies_at(cut_.surface, mesh_.places)));
  const std::size_t places = doubts.size();
  // Very many: the size is too coarse all over, and that is the caller's wish. But no faces may go
  // through each other.
  if (places == most_doubtful) doubts.clear();
  const double crossings = add_crossings(doubts);
  const bool fewer_places =
      !kept_ || static_cast<double>(places) < most_left * static_cast<double>(kept_->places);
  const bool better =
      !kept_ || crossings < kept_->crossings || (crossings == kept_->crossings && fewer_places);
  // Where sheets meet along a line, faces half as large cross twice as many others: there may be
  // more at first on the way to none.
  const auto per_side = [](double count, const ShellMesh& mesh) {
    return count / std::sqrt(static_cast<double>(mesh.faces.size()));
  };
  const bool helps =
      !kept_ || (better && fewer_places) ||
      per_side(crossings, mesh_) < most_left * per_side(kept_->crossings, kept_->mesh);
  if (!helps || doubts_ == most_doubts || round_ == most_rounds || doubts.empty()) {
    if (!better) take_kept();
    return;
  }
  ++doubts_;
  if (better) kept_ = {mesh_, size_, cut_.features, lines_, curves_, nodes_, crossings, places};
  (void)try_again(doubts);
}

/// Both sides of every crossing that the surface has not; returns their number.
double ChartRounds::add_crossings(std::vector<Fault>& doubts) const {
  double count = 0;
  std::vector<Index> faces;  // some cross many others
  for (const FaceCrossing& crossing : mesh_crossings(cut_.surface, mesh_)) {
    if (crossing.given) continue;
    faces.insert(faces.end(), crossing.faces.begin(), crossing.faces.end());
    ++count;
  }
  sort_unique(faces);
  for (const Index f : faces) doubts.push_back({{}, mesh_.places[mesh_.faces[f][0]], {}});
  return count;
}

std::vector<Fault> ChartRounds::faults_of(std::vector<ChartFailure>& failures) const {
  std::vector<Fault> faults;
  for (ChartFailure& failure : failures)
    faults.push_back(
        {std::move(failure.error), failure.place, cut_.atlas.charts[failure.chart].vertex});
  return faults;
}

std::vector<Fault> ChartRounds::faults_at(const std::vector<Violation>& violations) const {
  std::vector<Fault> faults;
  for (const Violation& wrong : violations) {
    faults.push_back({{ErrorCode::no_valid_mesh, wrong.what, {}}, {}, {}});
    if (wrong.vertex != none) faults.back().place = mesh_.places[wrong.vertex];
  }
  return faults;
}

/// Another round with smaller sizes, unless there have been enough.
Problem ChartRounds::try_again(const std::vector<Fault>& faults) {
  if (round_ == 1) divide_tips();
  if (round_ > 1) keep_vertices(faults);
  if (round_ == most_rounds || faulty_ == most_faulty || has_grown() ||
      !make_smaller(cut_.surface, faults, round_ > local_rounds, growth_of(options_), size_) ||
      (kept_ && surface_capacity(cut_.surface, size_) > options_.max_elements))
    return take_kept() ? std::nullopt : std::optional(failed(faults.front()));
  ++round_;
  done_ = false;
  return std::nullopt;
}

/// They have no mesh at any size. Tips of cuts alone are freed with them.
void ChartRounds::divide_tips() {
  mark_tips(cut_.surface, cut_.features);
  lines_ = features_and_cuts(cut_);
  mark_tips(cut_.surface, lines_);
}

/// Nodes alone may be too many, too, where curves keep those of a fine surface.
bool ChartRounds::has_grown() const {
  const auto nodes = static_cast<double>(nodes_.points.size());
  return surface_capacity(cut_.surface, size_) > some_quads + most_growth * capacity_at_first_ ||
         nodes > some_quads + most_growth * nodes_at_first_;
}

/// Chords that cut the vertices of thin charts may cross at every size. Vertices inside keep sheets
/// apart that nearly touch, but those of a surface far finer than the mesh would make it as fine.
void ChartRounds::keep_vertices(const std::vector<Fault>& faults) {
  std::vector<char> on_line(kept_vertices_.size(), 0);
  for (Index e = 0; e < static_cast<Index>(cut_.surface.twins.size()); ++e)
    if (lines_.half_edge_is_feature(e))
      on_line[cut_.surface.origin(e)] = on_line[cut_.surface.target(e)] = 1;
  std::vector<Index> inside;
  for (const Fault& fault : faults)
    for (const Index v : fault.everywhere) {
      if (on_line[v])
        kept_vertices_[v] = 1;
      else
        inside.push_back(v);
    }
  sort_unique(inside);
  if (static_cast<double>(inside.size()) > nodes_at_first_) return;
  for (const Index v : inside) kept_vertices_[v] = 1;
}

bool ChartRounds::take_kept() {
  if (!kept_) return false;
  mesh_ = std::move(kept_->mesh);
  size_ = std::move(kept_->size);
  cut_.features = std::move(kept_->features);
  lines_ = std::move(kept_->lines);
  curves_ = std::move(kept_->curves);
  nodes_ = std::move(kept_->nodes);
  kept_.reset();
  done_ = true;
  return true;
}

Error ChartRounds::failed(const Fault& fault) const {
  Vec3 at;
  if (fault.place.triangle != none)
    at = point_at(cut_.surface, fault.place);
  else if (!fault.everywhere.empty())
    at = cut_.surface.points[fault.everywhere[0]];
  else
    return {ErrorCode::no_valid_mesh, "No valid mesh was found: " + fault.error.message, {}};
  std::string message = "No mesh was found for the part of the surface near " +
                        place_in_space(at.x, at.y, at.z) + ": " + fault.error.message;
  if (has_grown())
    message += " The surface is narrow in many places; even quads of size " +
               short_number(size_there(fault)) +
               " are too large there, and smaller ones would be more than " +
               short_number(most_growth) + " times as many as asked for. Use a smaller size.";
  return {ErrorCode::no_valid_mesh, std::move(message), {}};
}

double ChartRounds::size_there(const Fault& fault) const {
  if (fault.place.triangle != none) return size_at(cut_.surface.triangles, fault.place, size_);
  double least = size_[fault.everywhere[0]];
  for (const Index v : fault.everywhere) least = std::min(least, size_[v]);
  return least;
}

}  // namespace lpq

// See mesh_charts.h.
#include "shell/mesh_charts.h"

#include <algorithm>

#include "numerics/elementary.h"
#include "pipeline/mesher.h"
#include "shell/chart_domain.h"
#include "shell/chart_fields.h"
#include "shell/place.h"

namespace lpq {
namespace {

// Sizes on a surface vary over lengths of some quads.
constexpr double fields_detail = 4;

/// Sizes and directions of a chart as the caller's own; they refer to `fields`.
UserFields fields_of_user(const Fields& fields) {
  UserFields user;
  Index hint = none;
  user.size = [&fields, hint](Vec2 p) mutable { return fields.size(p, hint); };
  user.detail = fields_detail * *std::min_element(fields.h.begin(), fields.h.end());
  user.angle = [&fields, hint](Vec2 p) mutable {
    const Vec2 axis = fields.sample(p, hint).axis;
    return arc_tangent(axis.y, axis.x);
  };
  return user;
}

}  // namespace

/// The mesher asks the fields while it runs: both stay where they are.
struct ChartsMesher::Job {
  const Chart& chart;
  ChartDomain domain;
  Fields fields;
  std::optional<Mesher> mesher;
};

ChartsMesher::ChartsMesher(const Charted& charted, const Options& options)
    : charted_(charted),
      options_(options),
      nodes_(charted.mesh, charted.lines.edges, charted.curves, charted.nodes) {
  options_.keep_boundary = true;
  options_.size = 0;
  ShellMesh& mesh = result_.mesh;
  mesh.points = charted.nodes.points;
  mesh.places.resize(mesh.points.size());
  pin_nodes();
}

ChartsMesher::~ChartsMesher() = default;

// Nodes on true features stay there; those on cuts alone are free in the end.
void ChartsMesher::pin_nodes() {
  ShellMesh& mesh = result_.mesh;
  mesh.pinned.assign(mesh.points.size(), 0);
  for (Index c = 0; c < charted_.curves.count(); ++c) {
    if (!charted_.features.is_feature(charted_.curves.edges.row(c)[0])) continue;
    const auto row = charted_.nodes.nodes.row(c);
    for (std::size_t k = 0; k < row.size(); ++k) {
      mesh.pinned[row[k]] = 1;
      if (k > 0) mesh.edges.push_back({std::min(row[k - 1], row[k]), std::max(row[k - 1], row[k])});
    }
  }
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    const Index v = charted_.nodes.places[n].vertex;
    if (v != none && charted_.features.corner[v]) mesh.pinned[n] = 2;
  }
  std::sort(mesh.edges.begin(), mesh.edges.end());
}

void ChartsMesher::step() {
  auto failure = step_in(charted_.atlas.charts[chart_]);
  if (failure) result_.failures.push_back({chart_, std::move(*failure)});
  if (!failure && job_->mesher->stage() != Stage::done) return;
  job_.reset();
  ++chart_;
}

std::optional<Error> ChartsMesher::step_in(const Chart& chart) {
  if (!job_) {
    job_ = std::make_unique<Job>(Job{
        chart,
        chart_domain(charted_.mesh, charted_.lines, charted_.curves, charted_.atlas, chart, nodes_),
        chart_fields(charted_.mesh, charted_.cross, charted_.size, chart), std::nullopt});
    auto mesher = Mesher::start(job_->domain.input, options_, fields_of_user(job_->fields));
    if (!mesher) return mesher.error();
    job_->mesher = std::move(*mesher);
  }
  if (const auto stage = job_->mesher->step(); !stage) return stage.error();
  if (job_->mesher->stage() == Stage::done) lift(*job_, job_->mesher->output());
  return std::nullopt;
}

void ChartsMesher::lift(const Job& job, const OutputMesh& plane) {
  ShellMesh& mesh = result_.mesh;
  std::vector<Index> number(plane.points.size());
  Index hint = none;
  for (std::size_t v = 0; v < plane.points.size(); ++v) {
    const Vec2 p = plane.points[v];
    const SurfacePlace place = place_on(job.chart, job.fields, p, hint);
    number[v] = static_cast<Index>(v) < plane.fixed ? job.domain.node_at(p) : none;
    if (number[v] == none) {
      number[v] = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(point_at(charted_.mesh, place));
      mesh.places.push_back(place);
      mesh.pinned.push_back(0);
    } else {
      mesh.places[number[v]] = place;
    }
  }
  for (const Face& face : plane.faces) {
    Face lifted{none, none, none, none};
    for (int k = 0; k < corner_count(face); ++k) lifted[k] = number[face[k]];
    mesh.faces.push_back(lifted);
    mesh.face.push_back(job.chart.face);
  }
}

}  // namespace lpq

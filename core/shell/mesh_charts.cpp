// See mesh_charts.h.
#include "shell/mesh_charts.h"

#include <algorithm>
#include <atomic>

#include "base/hash.h"
#include "base/share_out.h"
#include "numerics/elementary.h"
#include "pipeline/mesher.h"
#include "shell/chart_domain.h"
#include "shell/chart_fields.h"
#include "shell/place.h"

namespace lpq {
namespace {

// Sizes on a surface vary over lengths of some quads.
constexpr double fields_detail = 4;

/// How fine the fields of the plane must be, from place to place: a chart may have a size far below
/// all others in one spot.
std::vector<DomainInput::SizeAt> detail_of(const Fields& fields) {
  std::vector<DomainInput::SizeAt> detail;
  for (std::size_t v = 0; v < fields.h.size(); ++v)
    detail.push_back({fields.background.points[v], fields_detail * fields.h[v]});
  return detail;
}

/// Sizes and directions of a chart, and what they are measured after, as the caller's own; they
/// refer to `fields`.
UserFields fields_of_user(const Fields& fields) {
  UserFields user;
  Index hint = none;
  user.size = [&fields, hint](Vec2 p) mutable { return fields.size(p, hint); };
  user.sizes = detail_of(fields);
  user.detail = fields_detail * *std::max_element(fields.h.begin(), fields.h.end());
  user.angle = [&fields, hint](Vec2 p) mutable {
    const Vec2 axis = fields.sample(p, hint).axis;
    return arc_tangent(axis.y, axis.x);
  };
  if (!fields.stretch.empty())
    user.stretch = [&fields, hint](Vec2 p) mutable { return fields.stretch_at(p, hint); };
  return user;
}

std::uint64_t fingerprint(Index chart, const DomainInput& input, const Fields& fields) {
  Fnv1a hash;
  const auto add = [&hash](const Loop& line) {
    const std::size_t size = line.size();
    hash.add(std::span<const std::size_t>(&size, 1));
    hash.add(std::span<const Vec2>(line));
  };
  hash.add(std::span<const Index>(&chart, 1));
  for (const Loop& loop : input.regions[0].loops) add(loop);
  for (const auto& line : input.polylines) add(line.points);
  for (const auto& point : input.points) hash.add(std::span<const Vec2>(&point.position, 1));
  hash.add(std::span<const double>(fields.h));
  return hash.value();
}

}  // namespace

/// The mesher asks the fields while it runs: both stay where they are.
struct ChartsMesher::Job {
  const Chart& chart;
  ChartDomain domain;
  Fields fields;
  std::uint64_t key = 0;
  std::optional<Mesher> mesher;
};

ChartsMesher::ChartsMesher(const Charted& charted, const Options& options, PlaneMeshes& made)
    : charted_(charted),
      options_(options),
      made_(made),
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
  std::vector<std::array<std::array<Index, 2>, 2>> edges;  // with their sides
  for (Index c = 0; c < charted_.curves.count(); ++c) {
    if (!charted_.features.is_feature(charted_.curves.edges.row(c)[0])) continue;
    const auto row = charted_.nodes.nodes.row(c);
    mesh.pinned[row[0]] = 1;
    for (std::size_t k = 1; k < row.size(); ++k) {
      mesh.pinned[row[k]] = 1;
      const Index edge = k == 1 ? 0 : charted_.nodes.places[row[k - 1]].edge;
      const auto [along, against] = sides_of(c, edge);
      if (row[k - 1] < row[k])
        edges.push_back({{{row[k - 1], row[k]}, {along, against}}});
      else
        edges.push_back({{{row[k], row[k - 1]}, {against, along}}});
    }
  }
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    const Index v = charted_.nodes.places[n].vertex;
    if (v != none && charted_.features.corner[v]) mesh.pinned[n] = 2;
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [ends, sides] : edges) {
    mesh.edges.push_back(ends);
    mesh.sides.push_back(sides);
  }
}

/// Triangles along the surface's edge of this number on the curve, and against it.
std::array<Index, 2> ChartsMesher::sides_of(Index curve, Index number) const {
  std::array<Index, 2> sides{0, 0};
  const Index from = charted_.curves.vertices.row(curve)[number];
  const Index edge = charted_.curves.edges.row(curve)[number];
  for (const Index e : charted_.lines.edges.half_edges.row(edge))
    ++sides[charted_.mesh.origin(e) == from ? 0 : 1];
  return sides;
}

void ChartsMesher::step() {
  if (!job_) job_ = open(chart_);
  auto at = made_.find(job_->key);
  if (at == made_.end()) {
    auto mesh = step_in(*job_);
    if (!mesh) return;
    at = made_.emplace(job_->key, std::move(*mesh)).first;
  }
  if (at->second)
    lift(*job_, *at->second);
  else
    note(*job_, at->second.error());
  job_.reset();
  ++chart_;
}

bool ChartsMesher::mesh_planes(int threads, FunctionRef<bool(Index)> keep_going) {
  using Made = std::optional<Result<OutputMesh>>;
  const std::size_t count = charted_.atlas.charts.size();
  std::vector<Made> meshes(count);
  std::vector<std::uint64_t> keys(count);
  std::atomic<Index> over{0};
  std::atomic<bool> go_on{true};
  const auto ask = [&] { go_on = go_on && keep_going(over); };
  const auto mesh = [&](std::size_t chart, int thread) {
    if (!go_on) return;
    const std::unique_ptr<Job> job = open(static_cast<Index>(chart));
    keys[chart] = job->key;
    const bool known = made_.find(job->key) != made_.end();
    while (!known && go_on && !meshes[chart]) {
      meshes[chart] = step_in(*job);
      if (thread == 0) ask();
    }
    ++over;
  };
  share_out(count, threads, mesh, ask);
  for (std::size_t chart = 0; chart < count; ++chart)
    if (meshes[chart]) made_.emplace(keys[chart], std::move(*meshes[chart]));
  return go_on;
}

std::unique_ptr<ChartsMesher::Job> ChartsMesher::open(Index number) const {
  const Chart& chart = charted_.atlas.charts[number];
  auto job = std::make_unique<Job>(Job{
      chart,
      chart_domain(charted_.mesh, charted_.lines, charted_.curves, charted_.atlas, chart, nodes_),
      chart_fields(charted_.mesh, charted_.cross, charted_.size, chart), 0, std::nullopt});
  job->key = fingerprint(number, job->domain.input, job->fields);
  return job;
}

/// What became of the chart, once that is known.
std::optional<Result<OutputMesh>> ChartsMesher::step_in(Job& job) const {
  if (!job.mesher) {
    auto mesher = Mesher::start(job.domain.input, options_, fields_of_user(job.fields));
    if (!mesher) return mesher.error();
    job.mesher = std::move(*mesher);
  }
  if (const auto stage = job.mesher->step(); !stage) return stage.error();
  if (job.mesher->stage() != Stage::done) return std::nullopt;
  return job.mesher->output();
}

void ChartsMesher::note(const Job& job, const Error& error) {
  result_.failures.push_back({chart_, error, {}});
  Index hint = none;
  if (error.where.has_point)
    result_.failures.back().place =
        place_on(job.chart, job.fields, {error.where.x, error.where.y}, hint);
}

const Mesher* ChartsMesher::plane() const { return job_ ? &*job_->mesher : nullptr; }

std::vector<Vec3> ChartsMesher::lifted(std::span<const Vec2> points) const {
  std::vector<Vec3> lifted;
  lifted.reserve(points.size());
  Index hint = none;
  for (const Vec2 p : points)
    lifted.push_back(point_at(charted_.mesh, place_on(job_->chart, job_->fields, p, hint)));
  return lifted;
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

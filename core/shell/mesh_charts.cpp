// See mesh_charts.h.
#include "shell/mesh_charts.h"

#include <atomic>

#include "base/share_out.h"
#include "base/sort_numbers.h"
#include "shell/chart_run.h"
#include "shell/place.h"

namespace lpq {
namespace {

constexpr const char* no_plane = "The triangles there cannot be laid out flat.";

}  // namespace

std::string chart_words(const Error& error) {
  switch (error.code) {
    case ErrorCode::odd_boundary:
      return "Laid out flat, its border keeps an odd number of edges. Try another size.";
    case ErrorCode::lost_precision:
      return "Its coordinates are too coarse for so small a size. Try a larger size.";
    case ErrorCode::bad_size:
    case ErrorCode::bad_option:
    case ErrorCode::non_finite: return "Laid out flat, it gets no usable sizes. Try another size.";
    case ErrorCode::too_many_elements:
    case ErrorCode::too_large:
    case ErrorCode::out_of_memory:
    case ErrorCode::cancelled: return error.message;
    default: break;
  }
  if (error.where.loop == none && error.where.has_point)
    return "Laid out flat, it gets no convex quads. Try a smaller size.";
  if (error.where.loop == none && error.code == ErrorCode::no_valid_mesh)
    return "Laid out flat, it gets no valid mesh. Try a smaller size.";
  return "Laid out flat, its border meets itself. Try a smaller size.";
}

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
  mesh.pins.assign(mesh.points.size(), Pin::free);
  std::vector<std::array<std::array<Index, 2>, 2>> edges;  // with their sides
  for (Index c = 0; c < charted_.curves.count(); ++c) {
    if (!charted_.features.is_feature(charted_.curves.edges.row(c)[0])) continue;
    const auto row = charted_.nodes.nodes.row(c);
    mesh.pins[row[0]] = Pin::line;
    for (std::size_t k = 1; k < row.size(); ++k) {
      mesh.pins[row[k]] = Pin::line;
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
    if (v != none && charted_.features.corner[v]) mesh.pins[n] = Pin::corner;
  }
  sort_values(edges);
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

/// A chart for which no map was found has none.
bool ChartsMesher::has_plane(Index chart) const {
  return charted_.atlas.charts[chart].method != MapMethod::none_found;
}

void ChartsMesher::step() {
  if (!has_plane(chart_)) {
    result_.failures.push_back({chart_++, {ErrorCode::no_valid_mesh, no_plane, {}}, {}});
    return;
  }
  if (!run_) run_ = std::make_unique<ChartRun>(charted_, nodes_, chart_);
  auto at = made_.find(run_->key());
  if (at == made_.end()) {
    auto mesh = run_->step(options_);
    if (!mesh) return;
    at = made_.emplace(run_->key(), std::move(*mesh)).first;
  }
  if (at->second)
    lift(*at->second);
  else
    note(at->second.error());
  run_.reset();
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
    if (!go_on || !has_plane(static_cast<Index>(chart))) return;
    ChartRun run(charted_, nodes_, static_cast<Index>(chart));
    keys[chart] = run.key();
    const bool known = made_.find(run.key()) != made_.end();
    while (!known && go_on && !meshes[chart]) {
      meshes[chart] = run.step(options_);
      if (thread == 0) ask();
    }
    ++over;
  };
  share_out(count, threads, mesh, ask);
  for (std::size_t chart = 0; chart < count; ++chart)
    if (meshes[chart]) made_.emplace(keys[chart], std::move(*meshes[chart]));
  return go_on;
}

void ChartsMesher::note(const Error& error) {
  result_.failures.push_back({chart_, {error.code, chart_words(error), error.where}, {}});
  Index hint = none;
  if (error.where.has_point)
    result_.failures.back().place =
        place_on(run_->chart(), run_->fields(), {error.where.x, error.where.y}, hint);
}

const Mesher* ChartsMesher::plane() const { return run_ ? run_->mesher() : nullptr; }

std::vector<Vec3> ChartsMesher::lifted(std::span<const Vec2> points) const {
  std::vector<Vec3> lifted;
  lifted.reserve(points.size());
  Index hint = none;
  for (const Vec2 p : points)
    lifted.push_back(point_at(charted_.mesh, place_on(run_->chart(), run_->fields(), p, hint)));
  return lifted;
}

void ChartsMesher::lift(const OutputMesh& plane) {
  ShellMesh& mesh = result_.mesh;
  std::vector<Index> number(plane.points.size());
  Index hint = none;
  for (std::size_t v = 0; v < plane.points.size(); ++v) {
    const Vec2 p = plane.points[v];
    const SurfacePlace place = place_on(run_->chart(), run_->fields(), p, hint);
    number[v] = static_cast<Index>(v) < plane.fixed ? run_->domain().node_at(p) : none;
    if (number[v] == none) {
      number[v] = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(point_at(charted_.mesh, place));
      mesh.places.push_back(place);
      mesh.pins.push_back(Pin::free);
    } else {
      mesh.places[number[v]] = place;
    }
  }
  for (const Face& face : plane.faces) {
    Face lifted{none, none, none, none};
    for (int k = 0; k < corner_count(face); ++k) lifted[k] = number[face[k]];
    mesh.faces.push_back(lifted);
    mesh.face.push_back(run_->chart().face);
  }
}

}  // namespace lpq

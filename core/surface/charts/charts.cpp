#include "surface/charts/charts.h"

#include <utility>

#include "base/hash.h"
#include "base/sort_numbers.h"
#include "surface/charts/chart_maker.h"
#include "surface/components.h"

namespace lpq {
namespace {

// How much a bend counts as distance when a part is split because of its map: cuts then prefer to
// run along creases.
constexpr double bending_weight = 2;

std::uint64_t signature_of(const Part& part) {
  Fnv1a hash;
  hash.add(std::span<const Index>(part.triangles));
  return hash.value();
}

void count(Verdict verdict, ChartCounts& counts) {
  switch (verdict) {
    case Verdict::topology: ++counts.topology; break;
    case Verdict::flipped: ++counts.flips; break;
    case Verdict::crossing: ++counts.crossings; break;
    case Verdict::distorted: ++counts.distortions; break;
    case Verdict::accepted: break;
  }
}

}  // namespace

ChartMaker::ChartMaker(const SurfaceMesh& mesh, std::span<const char> feature,
                       const ChartOptions& options)
    : mesh_(mesh), options_(options), taker_(mesh), splitter_(mesh) {
  const Components faces = components_of(mesh.twins, feature);
  face_ = faces.of_triangle;
  chart_of_.assign(mesh.triangles.size(), none);
  atlas_.cut.assign(mesh.twins.size(), 0);
  for (Index e = 0; e < static_cast<Index>(mesh.twins.size()); ++e) {
    const Index twin = mesh.twins[e];
    atlas_.cut[e] = twin == none || face_[triangle_of(e)] != face_[triangle_of(twin)];
  }
  waiting_.resize(faces.count);
  for (Index t = 0; t < mesh.triangle_count(); ++t) waiting_[face_[t]].push_back(t);
}

PartMap ChartMaker::map(const Part& part, MapMethod last) {
  bool solved = false;
  PartMap result = map_part(mesh_, part, options_.limits, last, solved);
  atlas_.counts.maps += solved;
  return result;
}

void ChartMaker::remember_hopeless(const Part& part) { hopeless_.insert(signature_of(part)); }

bool ChartMaker::known_hopeless(const Part& part) const {
  return hopeless_.count(signature_of(part)) > 0;
}

void ChartMaker::keep(const Part& part, PartMap map) {
  Chart chart;
  chart.face = face_[part.triangles[0]];
  chart.triangles = part.triangles;
  chart.vertex = part.vertex;
  chart.plane.triangles = part.corners;
  chart.plane.twins = part.twins;
  chart.plane.region.assign(part.triangles.size(), 0);
  chart.borders = part.loops;
  for (Index& e : chart.borders.values) e = part.on_surface(e);
  chart.method = map.method;
  chart.check = map.check;
  if (map.verdict == Verdict::accepted) {
    // Only the first method knows lengths; the others leave them open.
    if (map.method != MapMethod::bff) scale_to_surface(mesh_, part, map.uv);
    chart.plane.points = std::move(map.uv);
    chart.scale = scales_of(mesh_, part, chart.plane.points);
  } else {
    chart.plane.points.assign(part.vertex.size(), {});
    chart.scale.assign(part.triangles.size(), 1.0);
    ++atlas_.counts.rejected;
  }
  const Index number = static_cast<Index>(atlas_.charts.size());
  for (const Index t : part.triangles) chart_of_[t] = number;
  atlas_.charts.push_back(std::move(chart));
}

void ChartMaker::mark(std::span<const Index> half_edges, char value) {
  for (const Index e : half_edges) atlas_.cut[e] = atlas_.cut[mesh_.twins[e]] = value;
}

// One cut turns a tube into a disk; it is worth it only if the disk's map is good.
bool ChartMaker::try_cut_open(const Part& part) {
  const std::vector<Index> way = splitter_.way_to_next_loop(part);
  if (way.empty()) return false;
  mark(way, 1);
  const Part opened = taker_.take(part.triangles, atlas_.cut);
  PartMap result = map(opened, MapMethod::scp);
  if (result.verdict != Verdict::accepted) {
    mark(way, 0);
    return false;
  }
  ++atlas_.counts.opened;
  keep(opened, std::move(result));
  return true;
}

void ChartMaker::separate_all(const Part& part) {
  for (const Index t : part.triangles)
    for (Index e = 3 * t; e < 3 * t + 3; ++e) atlas_.cut[e] = 1;
}

void ChartMaker::split(const Part& part, Verdict verdict) {
  count(verdict, atlas_.counts);
  const double bending = verdict == Verdict::topology ? 0 : bending_weight;
  cut_between(part, splitter_.far_pieces(part, 2, bending), atlas_.cut);
  Part pieces = taker_.take(part.triangles, atlas_.cut);
  Components components = components_of(pieces.twins);
  if (components.count < 2) {  // triangles in one place: no distance tells them apart
    separate_all(part);
    pieces = taker_.take(part.triangles, atlas_.cut);
    components = components_of(pieces.twins);
  }
  const std::size_t first = waiting_.size();
  waiting_.resize(first + components.count);
  for (Index t = 0; t < pieces.triangle_count(); ++t)
    waiting_[first + components.of_triangle[t]].push_back(pieces.triangles[t]);
}

void ChartMaker::work_on(std::vector<Index> triangles) {
  const Part part = taker_.take(std::move(triangles), atlas_.cut);
  PartMap result = map(part, MapMethod::symmetric_dirichlet);
  if (result.verdict == Verdict::accepted || part.triangle_count() == 1) {
    keep(part, std::move(result));
    return;
  }
  remember_hopeless(part);
  const bool tube = part.loops.rows() == 2 && part.genus() == 0;
  if (tube && try_cut_open(part)) return;
  split(part, result.verdict);
}

void ChartMaker::cut_up() {
  while (!waiting_.empty()) {
    std::vector<Index> triangles = std::move(waiting_.back());
    waiting_.pop_back();
    work_on(std::move(triangles));
  }
}

Atlas ChartMaker::finish() {
  sort_values(atlas_.charts,
              [](const Chart& a, const Chart& b) { return a.triangles[0] < b.triangles[0]; });
  return std::move(atlas_);
}

Atlas make_charts(const SurfaceMesh& mesh, std::span<const char> feature,
                  const ChartOptions& options) {
  ChartMaker maker(mesh, feature, options);
  maker.cut_up();
  maker.merge();
  return maker.finish();
}

}  // namespace lpq

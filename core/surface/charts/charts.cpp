#include "surface/charts/charts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "numerics/elementary.h"
#include "surface/charts/bff.h"
#include "surface/charts/conformal.h"
#include "surface/charts/split.h"
#include "surface/components.h"
#include "surface/frames.h"

namespace lpq {
namespace {

// How much a bend counts as distance when a part is split because of its map: cuts then prefer to
// run along creases.
constexpr double bending_weight = 2;

enum class Verdict { accepted, topology, flipped, crossing, distorted };

class ChartMaker {
 public:
  ChartMaker(const SurfaceMesh& mesh, std::span<const char> feature, const ChartOptions& options)
      : mesh_(mesh), feature_(feature), options_(options), taker_(mesh), splitter_(mesh) {}
  Atlas run();

 private:
  void start();
  void work_on(std::vector<Index> triangles);
  Verdict map(const Part& part, Chart& chart);
  bool too_domed(const Part& part) const;
  bool judge(const Part& part, MapMethod method, std::span<const Vec2> uv, Chart& chart,
             Verdict& verdict);
  void mark(std::span<const Index> half_edges, char value);
  bool try_cut_open(const Part& part);
  void split(const Part& part, Verdict verdict);
  void keep(const Part& part, Chart chart);

  const SurfaceMesh& mesh_;
  std::span<const char> feature_;
  ChartOptions options_;
  PartTaker taker_;
  Splitter splitter_;
  std::vector<Index> face_;
  std::vector<std::vector<Index>> waiting_;
  Atlas atlas_;
};

void ChartMaker::start() {
  const Components faces = components_of(mesh_.twins, feature_);
  face_ = faces.of_triangle;
  atlas_.cut.assign(mesh_.twins.size(), 0);
  for (Index e = 0; e < static_cast<Index>(mesh_.twins.size()); ++e) {
    const Index twin = mesh_.twins[e];
    atlas_.cut[e] = twin == none || face_[triangle_of(e)] != face_[triangle_of(twin)];
  }
  waiting_.resize(faces.count);
  for (Index t = 0; t < mesh_.triangle_count(); ++t) waiting_[face_[t]].push_back(t);
  std::reverse(waiting_.begin(), waiting_.end());
}

// A map that keeps the lengths of the border has no more room inside than a circle of that length.
bool ChartMaker::too_domed(const Part& part) const {
  double area = 0;
  for (const Index t : part.triangles) area += layout_of(mesh_, t).area;
  const double length = loop_length(part, 0), range = options_.limits.scale_range;
  return 4 * pi * area > range * range * length * length;
}

bool ChartMaker::judge(const Part& part, MapMethod method, std::span<const Vec2> uv, Chart& chart,
                       Verdict& verdict) {
  const MapCheck check = check_map(mesh_, part, uv);
  if (check.flipped > 0)
    verdict = Verdict::flipped;
  else if (check.crossing)
    verdict = Verdict::crossing;
  else
    verdict = check.within(options_.limits) ? Verdict::accepted : Verdict::distorted;
  if (verdict != Verdict::accepted) return false;
  chart.method = method;
  chart.check = check;
  chart.plane.points.assign(uv.begin(), uv.end());
  return true;
}

void ChartMaker::mark(std::span<const Index> half_edges, char value) {
  for (const Index e : half_edges) atlas_.cut[e] = atlas_.cut[mesh_.twins[e]] = value;
}

Verdict ChartMaker::map(const Part& part, Chart& chart) {
  if (part.loops.rows() == 0 || part.genus() > 0) return Verdict::topology;
  if (too_domed(part)) return Verdict::distorted;
  ++atlas_.counts.maps;
  Intrinsic disk = intrinsic_of(mesh_, part);
  flip_to_delaunay(disk);
  std::vector<Vec2> uv;
  Verdict verdict = Verdict::flipped;
  // Early judgement allows for what vertex values exaggerate.
  switch (map_bff(part, disk, 1.5 * options_.limits.scale_range, uv)) {
    case MapOutcome::distorted: return Verdict::distorted;
    case MapOutcome::unsolved: break;
    case MapOutcome::mapped:
      if (judge(part, MapMethod::bff, uv, chart, verdict) || verdict == Verdict::distorted)
        return verdict;
  }
  if (map_lscm(mesh_, part, disk, uv) && judge(part, MapMethod::lscm, uv, chart, verdict))
    return verdict;
  if (map_scp(part, disk, uv) && judge(part, MapMethod::scp, uv, chart, verdict)) return verdict;
  return verdict;
}

void ChartMaker::keep(const Part& part, Chart chart) {
  chart.face = face_[part.triangles[0]];
  chart.triangles = part.triangles;
  chart.vertex = part.vertex;
  chart.plane.triangles = part.corners;
  chart.plane.twins = part.twins;
  chart.plane.region.assign(part.triangles.size(), 0);
  chart.borders = part.loops;
  for (Index& e : chart.borders.values) e = part.on_surface(e);
  if (chart.method == MapMethod::none_found)
    chart.plane.points.assign(part.vertex.size(), {});
  else
    chart.scale = scales_of(mesh_, part, chart.plane.points);
  atlas_.charts.push_back(std::move(chart));
}

// One cut turns a tube into a disk; it is worth it only if the disk's map is good.
bool ChartMaker::try_cut_open(const Part& part) {
  const std::vector<Index> way = splitter_.way_to_next_loop(part);
  mark(way, 1);
  const Part opened = taker_.take(part.triangles, atlas_.cut);
  Chart chart;
  if (way.empty() || map(opened, chart) != Verdict::accepted) {
    mark(way, 0);
    return false;
  }
  ++atlas_.counts.loop_cuts;
  keep(opened, std::move(chart));
  return true;
}

void ChartMaker::split(const Part& part, Verdict verdict) {
  ChartCounts& counts = atlas_.counts;
  ++(verdict == Verdict::topology   ? counts.topology
     : verdict == Verdict::flipped  ? counts.flips
     : verdict == Verdict::crossing ? counts.crossings
                                    : counts.distortions);
  const double bending = verdict == Verdict::topology ? 0 : bending_weight;
  const std::vector<Index> labels = splitter_.far_pieces(part, 2, bending);
  cut_between(part, labels, atlas_.cut);
  Part pieces = taker_.take(part.triangles, atlas_.cut);
  Components components = components_of(pieces.twins);
  if (components.count < 2) {  // coincident triangles: no distance tells them apart
    for (const Index t : part.triangles)
      for (Index e = 3 * t; e < 3 * t + 3; ++e) atlas_.cut[e] = 1;
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
  Chart chart;
  const Verdict verdict = map(part, chart);
  if (verdict == Verdict::accepted) return keep(part, std::move(chart));
  if (part.triangle_count() == 1) {
    ++atlas_.counts.rejected;
    return keep(part, std::move(chart));
  }
  const bool tube = part.loops.rows() == 2 && part.genus() == 0;
  if (tube && try_cut_open(part)) return;
  split(part, verdict);
}

Atlas ChartMaker::run() {
  start();
  while (!waiting_.empty()) {
    std::vector<Index> triangles = std::move(waiting_.back());
    waiting_.pop_back();
    work_on(std::move(triangles));
  }
  return std::move(atlas_);
}

}  // namespace

const char* method_name(MapMethod method) {
  switch (method) {
    case MapMethod::bff: return "BFF";
    case MapMethod::lscm: return "LSCM";
    case MapMethod::scp: return "SCP";
    case MapMethod::symmetric_dirichlet: return "symmetric Dirichlet";
    case MapMethod::none_found: break;
  }
  return "none";
}

Atlas make_charts(const SurfaceMesh& mesh, std::span<const char> feature,
                  const ChartOptions& options) {
  return ChartMaker(mesh, feature, options).run();
}

}  // namespace lpq

// The paper's section 5, step by step: every chart is meshed in its plane by the planar chain and
// lifted back; since neighbours share the nodes of their curves, the union conforms.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "base/result.h"
#include "mesh/output_mesh.h"
#include "pipeline/options.h"
#include "shell/curve_nodes.h"
#include "shell/shell_mesh.h"
#include "surface/charts/charts.h"
#include "surface/cross_field.h"
#include "surface/curves.h"

namespace lpq {

class ChartRun;
class Mesher;

/// What the charts are meshed from; all of one surface.
struct Charted {
  const SurfaceMesh& mesh;
  const SurfaceFeatures& features;  // true ones
  const SurfaceCrossField& cross;
  std::span<const double> size;  // #V of the surface
  const Atlas& atlas;
  const SurfaceFeatures& lines;  // features and cuts, charts as faces
  const SurfaceCurves& curves;   // of `lines`
  const CurveMesh& nodes;        // of `curves`
};

/// A chart that could not be meshed, and why.
struct ChartFailure {
  Index chart = none;
  Error error;
  SurfacePlace place;  // where, if that is known
};

/// The sentence of a planar error where it is about a chart: the loops, edges and vertices of the
/// plane are nobody's but ours.
std::string chart_words(const Error& error);

/// Charts of one atlas in their planes, by ChartRun::key: when sizes change in one place, the other
/// charts need not be meshed again. Keys of 64 bits are taken to be different for different charts.
using PlaneMeshes = std::map<std::uint64_t, Result<OutputMesh>>;

struct MeshedCharts {
  ShellMesh mesh;
  std::vector<ChartFailure> failures;  // their faces are missing in the mesh
};

/// One chart after the other, in the steps of the planar chain.
class ChartsMesher {
 public:
  /// What `charted` refers to must outlive the mesher. `options`: of the planar chain; the boundary
  /// is always kept. `made`: of earlier meshers on the same atlas.
  ChartsMesher(const Charted& charted, const Options& options, PlaneMeshes& made);
  ~ChartsMesher();

  /// One step of the planar chain in the current chart; its last step lifts the mesh.
  void step();
  /// Meshes all charts in their planes at once, so that a step() is a chart from then on. The
  /// result does not depend on `threads`. `keep_going` is asked between steps, on this thread, with
  /// the number of charts that are over; false if it said no.
  bool mesh_planes(int threads, FunctionRef<bool(Index)> keep_going);
  bool done() const { return chart_ == static_cast<Index>(charted_.atlas.charts.size()); }
  Index chart() const { return chart_; }  // the current one: as many are over
  const MeshedCharts& result() const { return result_; }
  MeshedCharts take() { return std::move(result_); }

  const Mesher* plane() const;  // the run in the current chart; nullptr before its first step
  /// Points of the current chart's plane on the surface; while there is a plane().
  std::vector<Vec3> lifted(std::span<const Vec2> points) const;

 private:
  void pin_nodes();
  std::array<Index, 2> sides_of(Index curve, Index number) const;
  void lift(const OutputMesh& plane);
  bool has_plane(Index chart) const;
  void note(const Error& error);

  Charted charted_;
  Options options_;
  PlaneMeshes& made_;
  CurveNodes nodes_;
  MeshedCharts result_;
  Index chart_ = 0;
  std::unique_ptr<ChartRun> run_;  // in the current chart
};

}  // namespace lpq

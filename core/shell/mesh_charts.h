// The paper's section 5, step by step: every chart is meshed in its plane by the planar chain and
// lifted back; since neighbours share the nodes of their curves, the union conforms.
#pragma once

#include "base/monitor.h"
#include "base/result.h"
#include "pipeline/options.h"
#include "shell/shell_mesh.h"
#include "surface/charts/charts.h"
#include "surface/cross_field.h"
#include "surface/curves.h"

namespace lpq {

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
};

struct MeshedCharts {
  ShellMesh mesh;
  std::vector<ChartFailure> failures;  // their faces are missing in the mesh
};

/// `options`: of the planar chain; the boundary is always kept.
Result<MeshedCharts> mesh_charts(const Charted& charted, const Options& options,
                                 Monitor monitor = {});

}  // namespace lpq

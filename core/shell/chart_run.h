// The planar chain in one chart with the surface's field; against it, as far as the border allows,
// a plain ring where the map keeps angles, and where it keeps lengths a grid, too, and the chain
// with fields of its own if no cut borders the chart. The best mesh is kept.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "mesh/output_mesh.h"
#include "pipeline/mesher.h"
#include "shell/chart_domain.h"
#include "shell/mesh_charts.h"

namespace lpq {

/// Of a mesh in the plane: less is better.
struct MeshCost {
  double whole = 0, irregularity = 0;  // the second is a part of the first (IdealValence)
};

/// Stays where it is made: the mesher asks the fields while it runs. `charted` must outlive it; the
/// chart's border gets `nodes`. Cost: that of the planar chain, up to six times where it begins
/// again.
class ChartRun {
 public:
  ChartRun(const Charted& charted, const CurveNodes& nodes, Index chart);
  ChartRun(const ChartRun&) = delete;
  ChartRun& operator=(const ChartRun&) = delete;

  /// A fingerprint of what the mesh is made from, among runs over one atlas with the same options:
  /// chart, borders and sizes.
  std::uint64_t key() const { return key_; }
  /// One step of the planar chain; the mesh, or why there is none, once that is known.
  std::optional<Result<OutputMesh>> step(const Options& options);

  const Chart& chart() const { return chart_; }
  const ChartDomain& domain() const { return domain_; }
  const Fields& fields() const { return fields_; }
  /// nullptr before the first step of a run.
  const Mesher* mesher() const { return mesher_ ? &*mesher_ : nullptr; }

 private:
  Problem advance(const Options& options);
  bool repeats_a_try();
  bool keep_better(const QuadMesh& quads, double eta_min, OutputMesh output);
  bool take(std::optional<QuadMesh> grid, const Options& options);
  bool take_grids(const Options& options);
  bool may_gain(bool took_grid) const;
  bool begin_again(const Options& options);

  const Chart& chart_;
  ChartDomain domain_;
  Fields fields_;
  std::uint64_t key_ = 0;
  bool conformal_ = false;   // about
  bool isometric_ = false;   // but for a factor
  bool whole_face_ = false;  // no cut borders it
  // With fields of the chain's own: large triangles know one direction each, its background follows
  // the border.
  std::size_t tries_ = 0;
  std::vector<std::uint64_t> matched_;  // fingerprints of what tries began to clean up
  bool is_matched_ = false;             // has this try?
  std::optional<Mesher> mesher_;
  std::optional<OutputMesh> best_;
  MeshCost cost_;    // of the best
  Problem failure_;  // of the last try that failed
};

}  // namespace lpq

// The order of the stages on a surface, and nothing else: repair, features, fields, charts, curves,
// the planar chain in every chart, seams, shape, final check. The paper's section 5, with one cross
// field for all.
#pragma once

#include <memory>
#include <span>

#include "base/monitor.h"
#include "base/result.h"
#include "shell/options.h"
#include "shell/outcome.h"
#include "surface/soup.h"

namespace lpq {

class ChartsMesher;

enum class SurfaceStage { features, field, charts, mesh, seams, shape, done };
const char* stage_name(SurfaceStage stage);

/// A run in steps, forwards only. What a stage has made can be looked at from then on.
class SurfaceMesher {
 public:
  /// Repairs the surface. Errors: those of repair_surface, bad_option.
  static Result<SurfaceMesher> start(SurfaceSoup soup, const SurfaceOptions& options = {});
  SurfaceMesher(SurfaceMesher&&) noexcept;
  SurfaceMesher& operator=(SurfaceMesher&&) noexcept;
  ~SurfaceMesher();

  /// Advances by one stage, or in `mesh` by one step of the planar chain in one chart, in `seams`
  /// by one window, in `shape` by one patch or one descent over all. After the call stage() is what
  /// comes next. Errors: those of mesh_surface but cancelled.
  Result<SurfaceStage> step();

  /// In the stage `mesh`, before its first step: meshes all charts in their planes by threads; the
  /// steps to come only lift them, and the mesh is the same. Otherwise does nothing. False if
  /// `monitor` said no.
  bool mesh_planes(int threads, Monitor monitor);

  SurfaceStage stage() const;
  const SurfaceOptions& options() const;
  const SurfaceMesh& surface() const;       // as repaired
  const SurfaceFeatures& features() const;  // empty before their stages, as all that follows
  std::span<const double> sizes() const;    // #V of the surface
  const SurfaceCrossField& cross_field() const;
  const Atlas& atlas() const;
  Index charts_meshed() const;          // of the current round
  double share() const;                 // of the work of the stage, 0 to 1, as far as it is known
  const ChartsMesher* charts() const;   // while they are meshed; nullptr before and after
  const ShellMesh& mesh() const;        // of these charts, or of all
  const ShellOutcome& outcome() const;  // whole once done
  /// Once done, instead of a copy: surface(), atlas(), mesh() and outcome() are empty after it.
  ShellOutcome take();

 private:
  class Run;
  explicit SurfaceMesher(std::unique_ptr<Run> run);
  std::unique_ptr<Run> run_;
};

/// The whole run. `monitor` is asked between steps, on this thread; its iterations are charts,
/// after `mesh` hundredths of the stage. `threads`: for the charts, 0 = as many as the machine runs
/// at once, and at most four times as many; the mesh does not depend on it. Errors: those of
/// repair_surface, bad_option, bad_size, too_many_elements, no_valid_mesh, cancelled.
Result<ShellOutcome> mesh_surface(SurfaceSoup soup, const SurfaceOptions& options = {},
                                  Monitor monitor = {}, int threads = 0);

}  // namespace lpq

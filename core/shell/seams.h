// The last step on the union: cuts that are no features leave seams of irregular vertices. Windows
// over them, and then over the borders of these windows, are remeshed and smoothed in their planes,
// so that in the end nothing tells where a cut was. Then wider windows over the irregular vertices
// that are left: many could cancel another one far away.
#pragma once

#include <memory>

#include "pipeline/options.h"
#include "shell/mesh_charts.h"

namespace lpq {

struct SeamStats {
  Index windows = 0;   // opened
  Index accepted = 0;  // whose result was taken
  double in_vain = 0;  // triangles in those that could not be opened, for want of a map
};

/// Frees the nodes on cuts and remeshes around them, and around irregular vertices: in steps of one
/// window. On surfaces much finer than the mesh all that happens on a coarse ground
/// (coarse_ground.h), so that windows do not cost more there than elsewhere. Where hardly a window
/// has a map, as on noise, no more of them are tried: 800 triangles in vain for each of the
/// surface.
class SeamFinisher {
 public:
  /// What `charted` refers to must stay as it is until the end.
  SeamFinisher(const Charted& charted, const Options& options, ShellMesh mesh);
  ~SeamFinisher();

  /// False once all is done.
  bool step();
  double share() const;  // of the work, as far as it is known
  const SeamStats& stats() const;
  /// Once all is done.
  ShellMesh take();

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace lpq

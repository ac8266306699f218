// The last step on a mesh of a surface: its vertices move on the surface, in space, until its quads
// are as good as they get. Quads that are not convex are mended, if need be by other quads there.
#pragma once

#include <memory>

#include "cleanup/smooth.h"
#include "shell/mesh_charts.h"

namespace lpq {

struct ShapeStats {
  Index tangled_before = 0, tangled_after = 0;  // quads that are not strictly convex, or turned
  Index refilled = 0;                           // changes of connectivity
  Index reached = 0;                            // vertices put on tips of the surface
  Index eased = 0;                              // corners that moved along a crease
  int iterations = 0;                           // of the descent over all vertices
};

/// Maximises the sum of eta with the size terms of `options` (cleanup/shape_energy.h, angles in
/// space). Corners stay (but see acute.h), vertices on features slide along them in their order,
/// all others move freely on the surface. The number of tangled quads never grows, nor falls the
/// worst eta while none is tangled, except to 0.4 or by 0.005 where tips of the surface are reached
/// (tips.h), and by 0.01 where corners move. `mesh` has its nodes first, as ChartsMesher and
/// SeamFinisher leave it. In steps of one patch, or of one descent over all. Cost O(iterations #F).
class ShapeFinisher {
 public:
  /// What `charted` refers to must stay as it is until the end.
  ShapeFinisher(const Charted& charted, const SmoothOptions& options, ShellMesh mesh);
  ~ShapeFinisher();

  /// False once all is done.
  bool step();
  double share() const;  // of the work, roughly
  const ShapeStats& stats() const;
  /// Once all is done.
  ShellMesh take();

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace lpq

// Mends the worst quads of a mesh on a surface one after the other, each with a few rings of faces
// around it: by moving vertices, and where that is not enough by a change of connectivity.
#pragma once

#include <memory>

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"
#include "shell/shape/smoother.h"

namespace lpq {

/// Moves the vertices of a patch to where they are best, from anywhere. `area_factor`: as for
/// ShapeSmoother::descend_eta.
ShapeSmoother::Verdict smooth_patch(const ShapeGround& ground, const SmoothOptions& options,
                                    ShapePatch& patch, double area_factor = 1);

struct MendStats {
  Index moved = 0;     // patches that became better as they were
  Index refilled = 0;  // with other quads
};

/// In steps of one patch. All that is given must stay until the end.
class Mender {
 public:
  Mender(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
         std::vector<VertexRole>& roles);
  ~Mender();

  /// Mends a seed: a quad with eta below `bound`, or tangled; by other quads there if it is, or if
  /// `refill`. What is accepted has fewer tangled quads, or as many and less eta energy and no
  /// worse eta. False once there is none left and the mesh is whole.
  bool mend_next(double bound, bool refill);

  /// Eta descent on one of the overlapping patches that cover the mesh, for when a step that is
  /// small somewhere holds up a descent over all. A patch is kept as it was unless it becomes
  /// better, as above. False once all are done.
  bool smooth_next();

  double share() const;  // of the faces, looked at
  const MendStats& stats() const;

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace lpq

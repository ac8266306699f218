// Tips and ridges of the surface that the mesh cuts off: vertices beside them go there.
#pragma once

#include <memory>

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

/// Where a place of the surface (cover.h) lies far from the mesh for the size of the quads there, a
/// free vertex of the nearest quad is put on it and kept, and those around it move to where they
/// are best; unless that tangles quads, leaves poor ones, or uncovers more than it covers. Where
/// more than a quarter of the quads have such places, the mesh is too coarse all over and stays as
/// it is. Cost O(log #F) for each place, and some patches' descents for each tip. All that is given
/// must stay until the end.
class TipReacher {
 public:
  TipReacher(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
             ShellMesh& mesh, std::vector<VertexRole>& roles);
  ~TipReacher();

  /// Looks at some places, or reaches one tip. False once there is nothing left to do.
  bool step();
  Index reached() const;  // vertices put on tips

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace lpq

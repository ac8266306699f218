// Mends the worst quads of a mesh on a surface one after the other, each with a few rings of faces
// around it: by moving vertices, and where that is not enough by a change of connectivity.
#pragma once

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

struct MendStats {
  Index moved = 0;     // patches that became better as they were
  Index refilled = 0;  // with other quads
};

/// Seeds are quads with eta below `bound`, or not strictly convex. What is accepted has fewer
/// tangled quads, or as many and less eta energy and no worse eta.
MendStats mend_worst(const ShapeGround& ground, const SmoothOptions& options, double bound,
                     bool refill, ShellMesh& mesh, std::vector<VertexRole>& roles);

/// Eta descent on overlapping patches that cover the mesh, for when a step that is small somewhere
/// holds up a descent over all. A patch is kept as it was unless it becomes better, as above.
void smooth_patches(const ShapeGround& ground, const SmoothOptions& options, ShellMesh& mesh,
                    std::vector<VertexRole>& roles);

}  // namespace lpq

// Corners between creases of a scan that meet at so acute an angle that no quad there is good.
#pragma once

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

/// Where a poor quad has a corner at the end of a crease of noise, the corner moves on along one of
/// the creases there, as little as it takes and by less than a quarter of the mesh size, and the
/// vertices around it to where they are best; only if that makes the quad fair and the worst one at
/// the corner clearly better, and the worst one around not worse by more than 0.01, and all are
/// taken back where the mesh has a poor quad still: then the creases are worth more. Corners that
/// bound more than sharp edges stay, and so do those where every crease stands out, as on machined
/// parts. Returns how many moved.
Index ease_corners(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
                   ShellMesh& mesh, std::vector<VertexRole>& roles);

}  // namespace lpq

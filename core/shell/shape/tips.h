// Tips and ridges of the surface that the mesh cuts off: vertices beside them go there.
#pragma once

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

/// Where a place of the surface (cover.h) lies far from the mesh for the size of the quads there, a
/// free vertex of the nearest quad is put on it and kept, and those around it move to where they
/// are best; unless that tangles quads, leaves poor ones, or uncovers more than it covers. Returns
/// how many were put on tips. Cost O(log #F) for each place, and some patches' descents for each
/// tip.
Index reach_tips(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
                 ShellMesh& mesh, std::vector<VertexRole>& roles);

}  // namespace lpq

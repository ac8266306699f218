// Tips and ridges of the surface that the mesh cuts off: vertices beside them go there.
#pragma once

#include "cleanup/smooth.h"
#include "shell/shape/patch.h"

namespace lpq {

/// Where a vertex of the surface, or a place on an edge or in a triangle, lies far from the mesh
/// for the size of the quads there, a free vertex of the nearest quad is put on it and kept, and
/// those around it move to where they are best; unless that tangles quads or leaves poor ones.
/// Returns how many were put on tips. Places looked at: vertices, middles of edges longer than a
/// quarter of the mesh size, and points half a size apart in triangles. Cost O(log #F) for each.
Index reach_tips(const Charted& charted, const ShapeGround& ground, const SmoothOptions& options,
                 ShellMesh& mesh, std::vector<VertexRole>& roles);

}  // namespace lpq

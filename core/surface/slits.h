// Slits: where a triangulation has two points instead of one, and the border runs round the gap
// between them. CAD kernels leave them where vertices of faces agree within a tolerance only.
#pragma once

#include <span>
#include <vector>

#include "base/index.h"
#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// For each point the first that it is one with, itself if none is before it: points of one border
/// line (connected across its edges) within `reach`, where a border edge longer than a hundred
/// times that ends. What is small all round is a small thing, and sheets beside each other are
/// sheets. Empty if there is no slit. `reach` as for weld_points(). Cost O(#T log #T).
std::vector<Index> points_across_slits(std::span<const Vec3> points, std::span<const Tri> triangles,
                                       double reach);

}  // namespace lpq

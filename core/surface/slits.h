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

/// Borders that lie beside each other without meeting.
struct BorderGap {
  Index points = 0;  // with a point of another border near them
  double width = 0;  // the largest distance of two
  Vec3 at;           // one of the first two
};

/// Gaps up to `reach` wide between points whose border edges are longer than twenty times that;
/// none between points of different bodies (`body`: #V, or empty for one). Cost O(#T log #T).
BorderGap border_gap(std::span<const Vec3> points, std::span<const Tri> triangles, double reach,
                     std::span<const Index> body);

}  // namespace lpq

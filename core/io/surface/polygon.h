// Polygons of surface files as triangles on the same corners.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct DividedPolygon {
  std::vector<Tri> triangles;  // of the corners' numbers, two fewer than corners, turning with them
  bool turned = false;         // some look the other way, seen along the polygon's normal
};

/// A fan around the first corner from which all triangles look the same way. Where no corner sees
/// the whole polygon, ears are cut off one by one, the best shaped first, as seen along the
/// polygon's normal [M75]; beyond 4096 corners, and what has no ear since it crosses itself, is a
/// fan around its first. Three corners or more. Cost O(#corners^2) at most.
DividedPolygon divide_polygon(std::span<const Index> corners, const std::vector<Vec3>& points);

}  // namespace lpq

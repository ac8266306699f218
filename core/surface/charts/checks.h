// What a map must be to mesh in its plane: no triangle turned over, no border across another, sizes
// that differ by a bounded factor, and nearly the same in all directions.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"
#include "surface/charts/part.h"

namespace lpq {

struct MapLimits {
  double scale_range = 6;    // largest over smallest scale, half a per cent of the area left out
  double anisotropy = 1.35;  // sigma_1 / sigma_2 that 95 % of the area stay below
};

struct MapCheck {
  Index flipped = 0;      // triangles not turning left, by exact orientation
  bool crossing = false;  // borders meet, but for rounding; not looked at if triangles are flipped
  double scale_range = 1, anisotropy = 1;
  bool within(const MapLimits& limits) const {
    return scale_range <= limits.scale_range && anisotropy <= limits.anisotropy;
  }
};

MapCheck check_map(const SurfaceMesh& mesh, const Part& part, std::span<const Vec2> uv);

/// Triangles that do not turn left, exactly; those with a corner that is no number count as well.
Index count_flipped(const Part& part, std::span<const Vec2> uv);

/// Makes the map about as large altogether as the surface is there: by a power of two, with which
/// all that was checked stays as it is, so that lengths are right but for a factor of sqrt 2.
void scale_to_surface(const SurfaceMesh& mesh, const Part& part, std::span<Vec2> uv);

/// sqrt(area in the plane / area in space) of each triangle; that of the whole part for triangles
/// too flat to tell.
std::vector<double> scales_of(const SurfaceMesh& mesh, const Part& part, std::span<const Vec2> uv);

}  // namespace lpq

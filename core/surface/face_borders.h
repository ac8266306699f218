// Borders of faces as sides that run one of four ways, as the borders of a grid do [WWBB96].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "surface/curves.h"

namespace lpq {

inline constexpr Index right_angles_round = 4;

/// The direction in which one goes on after turning by so many right angles: 0, 1, 2 or 3.
Index direction_after(Index right_angles);

/// Part of a border on one curve: its length, in mesh sizes, in each of the four directions.
/// Direction 0 is that in which the border began.
struct BorderSide {
  Index curve = none;
  std::array<double, right_angles_round> length{};

  Index main_direction() const;
  bool is_straight() const { return length[main_direction()] == whole(); }
  double whole() const;
};

struct FaceBorder {
  Index face = none, turns = 0;  // right angles in all, to the left
  double angle = 0;              // by which it turns, radians
  double length = 0;             // in the unit of the surface
  std::vector<BorderSide> sides;
  std::array<Vec3, right_angles_round> run{};  // the way made in each direction
  bool round = false;                          // one bend all the way: does not count as turning
};

/// Goes round every border of every face. It turns where its angle is far from straight, or where a
/// bend is small beside the mesh, then by all of the bend; always by right angles (rounded). Where
/// these do not add up, a wide bend that is straight beside the mesh may be one, too. In order of
/// their first half-edge, those that start at a corner before those without one. `steps`: int ds/h
/// of each curve, #C; a mesh size is that of the curve, on average. Cost O(#T log #T).
std::vector<FaceBorder> face_borders(const SurfaceMesh& mesh, const SurfaceFeatures& features,
                                     const SurfaceCurves& curves, std::span<const double> steps);

}  // namespace lpq

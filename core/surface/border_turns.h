// How a border turns: by right angles, in bends.
#pragma once

#include <vector>

#include "geometry/vec3.h"
#include "surface/face_borders.h"

namespace lpq {

/// An edge on a border: its length in mesh sizes, by how much the border turns at its end, and the
/// way from its start to its end.
struct BorderStep {
  Index curve = none;
  double length = 0, turn = 0;  // radians, to the left
  bool ends_curve = false;
  Vec3 edge;
};

/// The sides of a closed border; its face is left open. The steps begin at a corner, if there is
/// one. Cost O(#steps log #steps).
FaceBorder border_of(std::vector<BorderStep> steps);

}  // namespace lpq

// Steps around a vertex of a TriMesh or SurfaceMesh. A half-edge stands for the corner at its
// origin; a "fan" is the run of corners that are reached from each other without crossing a wall.
#pragma once

#include "mesh/tri_mesh.h"

namespace lpq {

/// The next half-edge leaving the same vertex, counter-clockwise; none when a wall is in between.
template <class Mesh>
Index ccw_around_origin(const Mesh& mesh, Index e) {
  return mesh.twins[prev_in_triangle(e)];
}

/// Calls visit(e) for the half-edges of one fan, counter-clockwise from `first`, once around at
/// most.
template <class Mesh, class Visit>
void for_each_in_fan(const Mesh& mesh, Index first, Visit&& visit) {
  Index e = first;
  do {
    visit(e);
    e = ccw_around_origin(mesh, e);
  } while (e != none && e != first);
}

}  // namespace lpq

// How a triangulated surface bends: the second fundamental form of each triangle from the normals
// at its corners, which do not average across features [Rusinkiewicz 2004].
#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace lpq {

/// In the triangle's frame (surface/frames.h); positive where the surface bends away from its
/// normal, as a sphere seen from outside.
struct SecondForm {
  double xx = 0, xy = 0, yy = 0;
};

/// #T; zero for triangles without area. `feature` marks half-edges (both sides), empty for none.
std::vector<SecondForm> second_forms(const SurfaceMesh& mesh, std::span<const char> feature);

/// Largest |normal curvature| of a form.
double largest_curvature(const SecondForm& form);

}  // namespace lpq

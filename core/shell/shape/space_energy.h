// The energies of cleanup/shape_energy.h for quads in space: angles are those between the sides in
// space, as eta measures them, and a corner counts as positive by a normal of the face.
#pragma once

#include <array>

#include "cleanup/shape_energy.h"
#include "geometry/vec3.h"

namespace lpq {

using SpaceQuad = std::array<Vec3, 4>;

/// The total area of a mesh in a plane is what it is, but vertices on a curved surface can be
/// placed so that the quads cut off its tips and ridges, where angles do not add up to 360 degrees.
/// The cover term, minus the area, holds against that: where the surface is flat it does nothing.
struct SpaceEtaOptions : EtaEnergyOptions {
  double cover_weight = 0;  // times twice the area; the same for all faces of a mesh
};

/// eta energy (see there) of a quad; no pull. `unit` is 1/h^2. outside_domain when the sides at a
/// corner turn against the quad's own normal, or that normal against `outside`. Adds to `gradient`
/// (by the four corners).
Evaluation eta_energy(const SpaceQuad& p, double unit, Vec3 outside, const SpaceEtaOptions& options,
                      SpaceQuad& gradient);

/// Mean ratio energy (see there) of a quad as seen along the unit normal `outside`.
Evaluation mean_ratio_energy(const SpaceQuad& p, double unit, Vec3 outside,
                             const MeanRatioOptions& options, SpaceQuad& gradient);

/// Least corner of the quad seen along `outside`, as area of the parallelogram of its sides times
/// `unit`.
double smallest_corner(const SpaceQuad& p, double unit, Vec3 outside);

/// Strictly convex: every corner turns with the quad's own normal, and that looks to `outside`.
bool is_strictly_convex(const SpaceQuad& p, Vec3 outside);

}  // namespace lpq

// Quality of a shell mesh, measured in space.
#pragma once

#include <span>

#include "mesh/quality.h"
#include "pipeline/report.h"
#include "shell/shell_mesh.h"

namespace lpq {

/// eta of section 5 with the angles between the sides in space; 0 for a side without length.
double quad_eta(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// `nonconvex` counts quads with a corner that is straight or turns against the quad's own normal.
QuadQuality shell_quality(const ShellMesh& mesh);

/// Edge lengths over the targets at their ends. `size`: #V of the surface.
SizeFidelity shell_size_fidelity(const ShellMesh& mesh, std::span<const Tri> surface_triangles,
                                 std::span<const double> size);

}  // namespace lpq

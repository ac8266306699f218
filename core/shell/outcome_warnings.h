// What a mesh on a surface is not, told where it leaves: every defect with a count, the first place
// and what can be done.
#pragma once

#include <span>

#include "shell/outcome.h"

namespace lpq {

/// Adds warnings to the report, whose sizes and distances are known: where the mesh is far from the
/// surface, quads have become small or thin, go through each other, are not convex or look against
/// the surface, and where the given surface or its bodies go through each other. `size`: #V, of the
/// surface.
void warn_of_outcome(const SurfaceFeatures& features, std::span<const double> size,
                     ShellOutcome& outcome);

}  // namespace lpq

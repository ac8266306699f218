// The final check of a shell mesh: what can be proved about it without looking at its shape.
#pragma once

#include <string>
#include <vector>

#include "mesh/surface_mesh.h"
#include "mesh/validate.h"
#include "shell/shell_mesh.h"

namespace lpq {

/// Every vertex used and finite, no face with a vertex twice, every edge in two faces in opposite
/// directions, except edges of walls (`edges`), which have as many faces on either side as the
/// surface has there; the faces at a vertex hang together, but where the surface does not; the same
/// Euler number as the surface. At most `limit` violations; all name a vertex but those of unused
/// and infinite vertices and that of the Euler number. Cost O(#F log #F).
std::vector<Violation> check_shell(const SurfaceMesh& surface, const ShellMesh& mesh,
                                   std::size_t limit = 10);

}  // namespace lpq

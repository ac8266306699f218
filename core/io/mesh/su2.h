// SU2's native mesh (.su2, two-dimensional). Format: SU2 documentation, "Mesh file".
#pragma once

#include <string>

#include "mesh/output_mesh.h"

namespace lpq {

/// Faces region by region, then one marker for each name of boundary edges. Tagged edges inside
/// the domain are markers of their own (MARKER_INTERNAL of the configuration); untagged ones are
/// left out: a solver wants a boundary condition for every marker. SU2 has no place for regions and
/// tagged points: they stand in comments. Names become letters, digits and '_', unique.
std::string write_su2(const OutputMesh& mesh);

}  // namespace lpq

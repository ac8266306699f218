// Abaqus and CalculiX input (.inp). Format: "*NODE", "*ELEMENT", "*ELSET", "*NSET", "*SURFACE" of
// the Abaqus keywords guide and of the CalculiX CrunchiX manual, where the two agree: numbers of at
// most 20 characters, names of at most 80, 16 entries on a line.
#pragma once

#include <string>

#include "base/option_table.h"
#include "mesh/output_mesh.h"

namespace lpq {

/// Plane stress, plane strain, axisymmetric (x is the radius), or shell. Triangles get the
/// three-node element of the same kind.
enum class InpElement { cps4, cpe4, cax4, s4 };
template <>
struct ChoiceNames<InpElement> {
  static constexpr std::array<const char*, 4> names{"CPS4", "CPE4", "CAX4", "S4"};
};

/// One *ELSET per name of regions, one *NSET per name of edges and tagged points, and one *SURFACE
/// per name of edges (faces S1 .. S4 = corner 1-2, .. 4-1; of the element on the left of an edge
/// inside). Shells have three coordinates and no *SURFACE: the two programs name their edges
/// differently. A mesh in space is one of shells, whatever `element` says. Names become letters,
/// digits and '_', unique without regard to case.
std::string write_inp(const OutputMesh& mesh, InpElement element = InpElement::cps4);

}  // namespace lpq

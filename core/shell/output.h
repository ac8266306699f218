// A shell mesh as it leaves the library: the same struct as in the plane, so that every writer that
// knows heights can write it.
#pragma once

#include "mesh/output_mesh.h"
#include "shell/mesh_surface.h"

namespace lpq {

/// Regions are the faces of the surface: named after their group where it has a name (with the
/// number of the face behind it where the group has several), else "face 3". Edges are the features
/// and borders, curve by curve in the order they are walked, with tags "curve 1", .. as numbers and
/// names of their curves; a face is on their left wherever there is one on a side only. Numbers of
/// the faces as in mesh.face. Cost O(#V + #F + #E log #E).
OutputMesh shell_output(const ShellOutcome& outcome);

}  // namespace lpq

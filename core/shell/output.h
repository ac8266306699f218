// A shell mesh as it leaves the library: the same struct as in the plane, so that every writer that
// knows heights can write it.
#pragma once

#include "mesh/output_mesh.h"
#include "shell/mesh_surface.h"

namespace lpq {

/// Names of the surface's faces: that of their group where it has one (with the number of the face
/// behind it where the group has several), else "face 3".
std::vector<std::string> face_names(const ShellOutcome& outcome);

/// Regions are the faces of the surface with their names. Edges are the features and borders, curve
/// by curve in the order they are walked, with tags "curve 1", .. as numbers and names of their
/// curves; a face is on their left wherever there is one on a side only. Numbers of the faces as in
/// mesh.face. Cost O(#V + #F + #E log #E).
OutputMesh shell_output(const ShellOutcome& outcome);

}  // namespace lpq

// When no perfect matching exists, triangles split in three supply the partners that are missing.
#pragma once

#include "matching/blossom.h"
#include "mesh/tri_mesh.h"
#include "recombine/dual_graph.h"

namespace lpq {

/// The frugal repair: the Tutte-Berge witness is a set of triangles whose removal leaves too many
/// odd pieces; splits some that lie between two or three of these, near the unmatched triangles.
/// Returns the number of splits.
Index split_witness(TriMesh& mesh, const DualGraph& graph, const Matching& matching);

/// The sure repair: joins unmatched triangles u, u' in pairs by shortest ways. An unmatched
/// triangle next to x can be moved to x's partner y (u takes x), or past x to any other neighbour z
/// when x is split in three: u and y take the parts they face, and the part facing z is left. So
/// every way found lowers the deficiency by two. Returns the number of splits.
Index split_ways(TriMesh& mesh, const Matching& matching);

}  // namespace lpq

// Faces that go through each other: where a surface is thinner than what its quads cut off, those
// of its two sides do, and no check of how faces hang together sees it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/surface_mesh.h"
#include "shell/shell_mesh.h"

namespace lpq {

struct FaceCrossing {
  std::array<Index, 2> faces{none, none};  // ascending
  Vec3 at;                                 // in both
  bool given = false;                      // the surface goes through itself there, too
};

/// Pairs of faces that go through each other, by more than a small share of their sides and along
/// more than that: what only touches, or lies on the other, does not. Quads do if they do whichever
/// diagonals they are bent along. Not looked at: pairs that share a vertex, those of different
/// bodies, which may fit into each other (`body`: #V, or empty for one), and faces of hardly any
/// width. At most `limit`, ascending. Cost O(#F log #F) if faces are near a few others only.
std::vector<FaceCrossing> find_crossings(std::span<const Vec3> points, std::span<const Face> faces,
                                         std::span<const Index> body, std::size_t limit);

struct GivenCrossings {
  std::vector<FaceCrossing> within, between;  // one body, different bodies
};

/// Of the given surface: those of one body, as above, and those of different bodies that go into
/// each other by more than a tenth of `size` (#V), or than 0.15 of a triangle's side if that is
/// less: what only fits, as a bolt in its hole whose facets are turned, does not. At most 10,000 of
/// each. Cost: one search.
GivenCrossings given_crossings(const SurfaceMesh& surface, std::span<const double> size);

/// Of the mesh, at most 10,000; `given` if the boxes of a crossing pair of the surface reach there,
/// of which it may have any number. Cost: that of find_crossings() for the mesh, and if it has any
/// for the surface beside them.
std::vector<FaceCrossing> mesh_crossings(const SurfaceMesh& surface, const ShellMesh& mesh);

}  // namespace lpq

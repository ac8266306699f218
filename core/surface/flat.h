// Triangles without height. Their normals and angles mean nothing, and no later stage wants them.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace lpq {

/// Whether the corners lie on a line: none is further than `height` from the longest edge.
bool is_flat(Vec3 a, Vec3 b, Vec3 c, double height);

struct FlatRemoval {
  Index removed = 0;  // flat triangles taken away
  Index divided = 0;  // neighbours divided for that
  Index left = 0;     // flat triangles still there
};

/// The apex of a flat triangle lies on its longest edge; so every other triangle on that edge is
/// divided at the apex, and the flat one goes. No point moves and no gap opens, the surface stays
/// within `height`, and sheets that meet along the edge still meet. The longest edge of all flat
/// triangles comes first: what is divided there has shorter edges, so this ends. Rows of
/// `triangles` and `group` change; triangles of repeated corners go too. Needles (two corners
/// within `height` of each other) are left. Cost O((#flat + #divided) log #T).
FlatRemoval remove_flat_triangles(std::span<const Vec3> points, double height,
                                  std::vector<Tri>& triangles, std::vector<Index>& group);

}  // namespace lpq

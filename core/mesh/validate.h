// The final check, run on every result by default: what it proves is what the README promises.
//
// Why these local checks suffice: when every face is strictly convex and counter-clockwise, the
// number of faces over a generic point of the plane equals the winding number of the mesh boundary
// around it. If the boundary edges are exactly the expected ones, that number is 1 inside the
// domain and 0 outside, so the faces cover the domain exactly once, without any test of overlap.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"

namespace lpq {

struct Violation {
  std::string what;  // a sentence
  Index face = none, vertex = none;
  Vec2 point;
};

struct ExpectedBoundary {
  // Directed, domain on the left. A vertex that several of them leave (regions that touch in a
  // point) may have as many fans, any other vertex has exactly one.
  std::span<const std::array<Index, 2>> edges;
  // Empty, or the positions that the first vertices must have, bit for bit.
  std::span<const Vec2> points = {};
};

/// Exact: every corner strictly convex, every edge in at most two faces in opposite directions, one
/// fan per vertex, boundary edges equal to the expected ones, every vertex used, no coincident
/// vertices, walls present as inner edges, indices in range. The signs are those of the coordinates
/// given, so pass the caller's coordinates to prove the result the caller receives.
/// At most `limit` violations are listed. Cost O(#F).
std::vector<Violation> validate(const QuadMesh& mesh, const ExpectedBoundary& boundary,
                                std::size_t limit = 10);

/// Twins reciprocal, triangles counter-clockwise, regions set, free vertices inside one fan.
std::vector<Violation> validate(const TriMesh& mesh, std::size_t limit = 10);

}  // namespace lpq

// What holds of every grid over a face.
#pragma once

#include <algorithm>

#include "catch.h"
#include "cleanup/quad_topology.h"
#include "cleanup/untangle.h"
#include "domain/boundary.h"

namespace lpq_test {

/// No vertex inside is irregular, and every edge of the border has its quad.
inline void check_grid(const lpq::BoundaryMesh& boundary, const lpq::QuadMesh& grid) {
  using namespace lpq;
  CHECK(invalid_faces(grid).empty());
  const QuadTopology topology{QuadMesh(grid)};
  REQUIRE(grid.fixed == static_cast<Index>(boundary.points.size()));
  CHECK(std::equal(boundary.points.begin(), boundary.points.end(), grid.points.begin()));
  for (Index v = grid.fixed; v < topology.vertex_count(); ++v) CHECK(topology.valence(v) == 4);
  for (const Segment& edge : boundary.edges) {
    const bool forward = edge.left != none;
    CHECK(topology.face_with_edge(forward ? edge.a : edge.b, forward ? edge.b : edge.a) != none);
  }
}

}  // namespace lpq_test

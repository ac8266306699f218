// Midpoint subdivision: valid on every triangulation, whatever the triangles.
#include "recombine/subdivide.h"

#include <cmath>

#include "catch.h"
#include "delaunay/delaunay.h"
#include "domain/boundary.h"
#include "domain/domain.h"
#include "mesh/validate.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

void require_valid_subdivision(const DomainInput& input) {
  const auto domain = make_domain(input);
  REQUIRE(domain);
  const auto boundary = sample_boundary(*domain, {.keep = true, .require_even = false});
  REQUIRE(boundary);
  const auto triangles = triangulate(*boundary, {});
  REQUIRE(triangles);
  const QuadMesh quads = subdivide_triangles(*triangles, *boundary, domain->frame);
  const BoundaryMesh fine = halve_edges(*boundary, domain->frame);

  CHECK(quads.faces.size() == 3 * triangles->triangles.size());
  CHECK(quads.fixed == 2 * static_cast<Index>(boundary->points.size()));
  CHECK(fine.edges.size() == 2 * boundary->edges.size());
  std::vector<std::array<Index, 2>> outline;
  for (const Segment& s : fine.edges)
    if (s.right == none) outline.push_back({s.a, s.b});
  const auto violations = validate(quads, {outline});
  CHECK(violations.empty());
  for (std::size_t v = 0; v < boundary->points.size(); ++v)
    CHECK(quads.points[v] == boundary->points[v]);
}

}  // namespace

TEST_CASE("three convex quads per triangle, on shapes without any interior point") {
  require_valid_subdivision(domain_of({{{0, 0}, {1, 0}, {0, 1}}}));
  require_valid_subdivision(l_shape(0.3));
  require_valid_subdivision(annulus(0.1));
}

TEST_CASE("needles are subdivided validly") {
  require_valid_subdivision(domain_of({{{0, 0}, {1, 0.001}, {2, 0}, {1, 0.0011}}}));
  Loop comb;
  for (int i = 0; i < 20; ++i) {
    comb.push_back({i * 1e-3, 0});
    comb.push_back({i * 1e-3 + 4e-4, i % 2 == 0 ? 1.0 : 0.3});
  }
  comb.push_back({0.02, -1});
  require_valid_subdivision(domain_of({comb}));
}

// The whole clean-up on meshes with every kind of trouble.
#include "cleanup/cleanup.h"

#include "catch.h"
#include "cleanup/untangle.h"
#include "mesh/quality.h"
#include "mesh/validate.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

QuadMesh trouble(std::uint64_t seed) { return shaken(scrambled(14, 11, 40, seed), 0.5, seed); }

void check_kept(const QuadMesh& result, const QuadMesh& start) {
  CHECK(result.fixed == start.fixed);
  for (Index v = 0; v < start.fixed; ++v) CHECK(result.points[v] == start.points[v]);
  CHECK(border_of(result) == border_of(start));
}

}  // namespace

TEST_CASE("every mess becomes a valid mesh of good quads on the same boundary") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const QuadMesh start = trouble(seed);
    const CleanupResult result = clean_up(start, uniform_fields(start, 1));
    CHECK(result.stats.still_invalid == 0);
    check_kept(result.mesh, start);
    const auto border = border_of(start);
    CHECK(validate(result.mesh, {border}).empty());
    const QuadQuality quality = quad_quality(result.mesh);
    CHECK(quality.eta_mean > 0.8);
    CHECK(quality.eta_min > 0.4);
    CHECK(quality.four_valent_percent > quad_quality(start).four_valent_percent);
  }
}

TEST_CASE("the paper's clean-up changes connectivity only for validity") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const QuadMesh start = trouble(seed);
    CleanupOptions options;
    options.topology = false;
    const CleanupResult result = clean_up(start, uniform_fields(start, 1), options);
    check_kept(result.mesh, start);
    CHECK(result.stats.still_invalid == 0);
    QuadMesh valid = shaken(grid(8, 7), 0.3, seed);
    const CleanupResult plain = clean_up(valid, uniform_fields(valid, 1), options);
    CHECK(plain.mesh.faces == valid.faces);
    CHECK(quad_quality(plain.mesh).eta_mean > quad_quality(valid).eta_mean);
  }
}

TEST_CASE("the same input gives the same bytes") {
  const QuadMesh start = trouble(3);
  const Fields fields = uniform_fields(start, 1);
  const CleanupResult one = clean_up(start, fields), two = clean_up(start, fields);
  CHECK(one.mesh.points == two.mesh.points);
  CHECK(one.mesh.faces == two.mesh.faces);
}

TEST_CASE("scaling by a power of two scales the result") {
  const QuadMesh start = trouble(5);
  QuadMesh half = start;
  for (Vec2& p : half.points) p = 0.5 * p;
  const CleanupResult one = clean_up(start, uniform_fields(start, 1));
  const CleanupResult two = clean_up(half, uniform_fields(half, 0.5));
  CHECK(one.mesh.faces == two.mesh.faces);
  REQUIRE(one.mesh.points.size() == two.mesh.points.size());
  for (std::size_t v = 0; v < one.mesh.points.size(); ++v)
    CHECK(0.5 * one.mesh.points[v] == two.mesh.points[v]);
}

TEST_CASE("quad-dominant meshes keep their triangles") {
  QuadMesh start = shaken(grid(8, 8), 0.4, 2);
  for (const std::size_t f : {10u, 30u}) {
    const Face face = start.faces[f];
    start.faces[f] = {face[0], face[1], face[2], none};
    start.faces.push_back({face[0], face[2], face[3], none});
    start.region.push_back(0);
  }
  const CleanupResult result = clean_up(start, uniform_fields(start, 1));
  CHECK(result.stats.still_invalid == 0);
  CHECK(quad_quality(result.mesh).triangles == 4);
  check_kept(result.mesh, start);
}

TEST_CASE("an empty mesh and a single quad pass through") {
  CHECK(clean_up({}, uniform_fields(grid(1, 1), 1)).mesh.faces.empty());
  const QuadMesh one = grid(1, 1);
  CHECK(clean_up(one, uniform_fields(one, 1)).mesh.faces == one.faces);
}

// The whole of patch remeshing: fewer irregular vertices, the same boundary, valid faces.
#include "patches/remesh.h"

#include "catch.h"
#include "cleanup/cleanup.h"
#include "cleanup/smooth.h"
#include "delaunay/delaunay.h"
#include "mesh/quality.h"
#include "mesh/validate.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/mesher.h"
#include "pipeline/prepare.h"
#include "recombine/recombine.h"
#include "support/cleanup_meshes.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

QuadMesh remeshed(const QuadMesh& start, const Fields& fields, const PatchOptions& options = {}) {
  PatchRemesher remesher(start, fields, options);
  while (remesher.step(7)) {
  }
  return remesher.mesh();
}

double irregularity_of(const QuadMesh& mesh) {
  const QuadTopology topology(mesh);
  return IdealValence(topology).total_weight(topology);
}

QuadMesh trouble(std::uint64_t seed) {
  const QuadMesh start = shaken(scrambled(14, 11, 40, seed), 0.5, seed);
  CleanupOptions options;
  options.topology = false;
  return clean_up(start, uniform_fields(start, 1), options).mesh;
}

PatchOptions annealing() {
  PatchOptions options;
  options.passes = {{20}, {60}, {200, 1.5, 20}, {60}};
  return options;
}

void check_sound(const QuadMesh& mesh, const QuadMesh& start) {
  CHECK(mesh.fixed == start.fixed);
  for (Index v = 0; v < start.fixed; ++v) CHECK(mesh.points[v] == start.points[v]);
  const auto border = border_of(start);
  CHECK(validate(mesh, {border}).empty());
}

}  // namespace

TEST_CASE("a regular mesh stays as it is") {
  const QuadMesh start = grid(8, 6);
  const QuadMesh mesh = remeshed(start, uniform_fields(start, 1));
  CHECK(mesh.faces == start.faces);
}

//  +--+--+--+--+       +--+--+--+--+
//  |  |\ |  |  |       |  |  |  |  |     scrambled: edges turned at random, vertices shaken
//  +--+ \+-(5)-+   ->  +--+--+--+--+
//  | (3) | /|  |       |  |  |  |  |
TEST_CASE("a scrambled grid becomes a grid again") {
  int perfect = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const QuadMesh start = trouble(seed);
    const QuadMesh mesh = remeshed(start, uniform_fields(start, 1));
    check_sound(mesh, start);
    CHECK(irregularity_of(mesh) <= irregularity_of(start));
    perfect += irregularity_of(mesh) == 0;
  }
  CHECK(perfect >= 6);
}

TEST_CASE("a second run changes nothing or improves") {
  const QuadMesh start = trouble(5);
  const Fields fields = uniform_fields(start, 1);
  const QuadMesh one = remeshed(start, fields), two = remeshed(one, fields);
  check_sound(two, start);
  CHECK(irregularity_of(two) <= irregularity_of(one));
}

TEST_CASE("steps of any size give the same bytes, annealing too") {
  const QuadMesh start = trouble(3);
  const Fields fields = uniform_fields(start, 1);
  PatchRemesher one(start, fields, annealing()), many(start, fields, annealing());
  while (one.step(1)) {
  }
  while (many.step(1000)) {
  }
  CHECK(one.mesh().points == many.mesh().points);
  CHECK(one.mesh().faces == many.mesh().faces);
}

TEST_CASE("a copy goes its own way to the same end") {
  const QuadMesh start = trouble(4);
  const Fields fields = uniform_fields(start, 1);
  PatchRemesher remesher(start, fields);
  remesher.step(3);
  PatchRemesher copy = remesher;
  while (copy.step(5)) {
  }
  while (remesher.step(5)) {
  }
  CHECK(copy.mesh().points == remesher.mesh().points);
}

TEST_CASE("every stage can be seen") {
  auto mesher = Mesher::start(disc(0.1), {.keep_boundary = true});
  REQUIRE(mesher);
  mesher->keep_trace();
  bool patch_seen = false, smooth_seen = false;
  while (mesher->stage() != Stage::done) {
    REQUIRE(mesher->step());
    patch_seen |= mesher->stage() == Stage::patch;
    smooth_seen |= mesher->stage() == Stage::smooth;
  }
  CHECK(patch_seen);
  CHECK(smooth_seen);
  std::vector<std::string> names;
  for (const QuadStage& stage : mesher->trace()->quads) names.push_back(stage.name);
  CHECK(names == std::vector<std::string>{"matched", "cleaned", "patched", "smoothed"});
}

// The paper's Fig. 12 and 60 starts like it: interior points of an 11 x 11 square moved at random.
TEST_CASE("every bad start of the square ends perfect") {
  const Options options{.keep_boundary = true};
  const auto prepared = prepare(square(1, 0.1), options, {});
  REQUIRE(prepared);
  for (const double jitter : {0.35, 0.4, 0.6})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(jitter, seed);
      std::vector<Vec2> seeds = jittered_grid(11, jitter, seed);
      for (Vec2& p : seeds) p = prepared->domain.frame.to_frame(p);
      const auto triangles = triangulate(prepared->boundary, seeds);
      REQUIRE(triangles);
      QuadMesh start = recombine(*triangles, prepared->fields, {}).mesh;
      start = clean_up(std::move(start), prepared->fields).mesh;
      QuadMesh mesh = remeshed(start, prepared->fields);
      for (const double rounding : {coarse_rounding, 0.003})
        smooth_eta(mesh, prepared->fields, {.iterations = 200, .rounding = rounding});
      const QuadQuality quality = quad_quality(mesh);
      CHECK(irregularity_of(mesh) == 0);
      CHECK(quality.eta_min > 0.99);
      CHECK(quality.quads == 100);
    }
}

TEST_CASE("patches pay on curved domains, and sizes are kept") {
  for (const DomainInput& input : {disc(0.05), plate_with_hole(0.05), hood(0.05)}) {
    const auto outcome = mesh_domain(input, {.keep_boundary = true});
    REQUIRE(outcome);
    CHECK(outcome->report.quality.eta_mean > 0.92);
    CHECK(outcome->report.quality.four_valent_percent > 95);
    CHECK(outcome->report.quality.eta_min > 0.55);
    CHECK(outcome->report.size.p10 > 0.75);
    CHECK(outcome->report.size.p90 < 1.35);
  }
}

TEST_CASE("where triangles may stay, few do, and quads are no worse than without") {
  for (const double h : {0.05, 0.07}) {
    DomainInput input;
    input.regions.push_back({"", {circle({0, 0}, 1, h)}, {}});
    const auto eta_of_quads = [](const OutputMesh& mesh) {
      double sum = 0, count = 0;
      for (const Face& face : mesh.faces)
        if (corner_count(face) == 4) sum += face_eta(mesh.points, face), ++count;
      return sum / count;
    };
    const auto mixed =
        mesh_domain(input, {.keep_boundary = true, .elements = Elements::quad_dominant});
    const auto quads = mesh_domain(input, {.keep_boundary = true, .allow_added_point = true});
    REQUIRE(mixed);
    REQUIRE(quads);
    CHECK(mixed->report.quality.triangles < 0.04 * mixed->report.quality.quads);
    CHECK(eta_of_quads(mixed->mesh) > eta_of_quads(quads->mesh) - 0.015);
  }
}

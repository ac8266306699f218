// High effort goes on from what normal effort ends with: never to a worse mesh, always to the same.
#include <string>

#include "catch.h"
#include "mesh/quality.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/mesher.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const Options normal{.keep_boundary = true};
const Options high{.keep_boundary = true, .effort = Effort::high};

Outcome meshed(const DomainInput& input, const Options& options) {
  auto outcome = mesh_domain(input, options);
  REQUIRE(outcome);
  return std::move(*outcome);
}

// What the whole mesh is judged by where two are to choose from.
double merit(const Outcome& outcome) {
  const QuadQuality& quality = outcome.report.quality;
  return quality.eta_mean + 0.01 * quality.four_valent_percent;
}

}  // namespace

TEST_CASE("high effort never ends with a worse mesh than normal effort", "[slow]") {
  int better = 0;
  for (const DomainInput& input : {disc(0.06), disc(0.1), plate_with_hole(0.06), hood(0.07)})
    for (const std::uint64_t seed : {1, 2}) {
      Options chance = high;
      chance.seed = seed;
      const Outcome before = meshed(input, normal), after = meshed(input, chance);
      CHECK(after.report.quality.triangles <= before.report.quality.triangles);
      CHECK(merit(after) >= merit(before));
      CHECK(check_output(after.mesh).empty());
      better += merit(after) > merit(before);
    }
  CHECK(better > 0);
}

TEST_CASE("the last of the quads recorded are those of the result", "[slow]") {
  for (const DomainInput& input : {disc(0.1), hood(0.07), square(1, 0.1)})
    for (const int iterations : {-1, 10}) {
      Options options = high;
      options.iterations = iterations;
      Trace trace;
      const auto outcome = mesh_domain(input, options, {}, &trace);
      REQUIRE(outcome);
      const QuadQuality recorded = quad_quality(trace.quads.back().mesh);
      CHECK(recorded.quads == outcome->report.quality.quads);
      CHECK(recorded.eta_mean == outcome->report.quality.eta_mean);
    }
}

TEST_CASE("where all is perfect, high effort changes nothing") {
  const DomainInput input = square(1, 0.1);
  CHECK(meshed(input, high).report.hash == meshed(input, normal).report.hash);
}

TEST_CASE("high effort ends with the same bytes, stepped, copied or in one go") {
  const DomainInput input = hood(0.08);
  const Outcome batch = meshed(input, high);
  auto mesher = Mesher::start(input, high);
  REQUIRE(mesher);
  bool checked = false, annealing = false;
  while (!annealing) {
    REQUIRE(mesher->step());
    annealing = checked && mesher->stage() == Stage::patch;
    checked |= mesher->stage() == Stage::check;
    REQUIRE(mesher->stage() != Stage::done);
  }
  for (int i = 0; i < 3; ++i) REQUIRE(mesher->step());
  Mesher copy = *mesher;
  while (mesher->stage() != Stage::done) REQUIRE(mesher->step());
  while (copy.stage() != Stage::done) REQUIRE(copy.step());
  CHECK(mesher->report().hash == batch.report.hash);
  CHECK(copy.report().hash == batch.report.hash);
}

TEST_CASE("annealing can be cancelled at any of its many steps") {
  struct Watch {
    bool checked = false;
    int asked = 0;  // in the patches after the first check
  } watch;
  const auto keep_going = [](const Progress& progress, void* user) {
    Watch& seen = *static_cast<Watch*>(user);
    const std::string stage = progress.stage;
    seen.checked |= stage == "check";
    seen.asked += seen.checked && stage == "patch";
    return seen.asked < 5;
  };
  const auto outcome = mesh_domain(hood(0.08), high, Monitor{keep_going, &watch});
  REQUIRE(!outcome);
  CHECK(outcome.error().code == ErrorCode::cancelled);
  CHECK(watch.asked == 5);
}

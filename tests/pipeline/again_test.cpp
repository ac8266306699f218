// The finishing steps on their own result: a second run may improve it, but makes nothing worse.
#include "catch.h"
#include "cleanup/cleanup.h"
#include "mesh/quality.h"
#include "patches/remesh.h"
#include "pipeline/mesher.h"
#include "pipeline/shape_options.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

// Where smoothing has converged, another block moves eta by no more than this (mesher.cpp).
constexpr double converged = 1e-3;

Index irregular(const QuadQuality& quality) {
  return quality.interior_vertices - quality.regular_vertices;
}

void check_not_worse(const QuadQuality& now, const QuadQuality& before) {
  CHECK(now.triangles == before.triangles);
  CHECK(now.inverted + now.nonconvex == 0);
  CHECK(irregular(now) <= irregular(before));
  CHECK(now.eta_mean > before.eta_mean - converged);
  CHECK(now.eta_min > before.eta_min - 0.01);
}

QuadMesh smoothed(QuadMesh mesh, const Fields& fields, const Options& options) {
  SmoothOptions smoothing = shape_smoothing(options);
  smoothing.iterations = 300;
  smoothing.rounding = 0.003;
  smooth_eta(mesh, fields, smoothing);
  return mesh;
}

QuadMesh patched(const QuadMesh& mesh, const Fields& fields, const Options& options) {
  PatchRemesher patches(mesh, fields, patch_options(options));
  while (patches.step(1000)) {
  }
  return patches.mesh();
}

void check_again(const DomainInput& input, const Options& options) {
  auto mesher = Mesher::start(input, options);
  REQUIRE(mesher);
  while (mesher->stage() != Stage::done) REQUIRE(mesher->step());
  const QuadMesh& mesh = mesher->quads();
  const Fields& fields = mesher->fields();
  const QuadQuality before = quad_quality(mesh);
  INFO("smoothing alone");
  check_not_worse(quad_quality(smoothed(mesh, fields, options)), before);
  const CleanupResult cleaned = clean_up(mesh, fields, cleanup_before_patches(options));
  CHECK(cleaned.stats.still_invalid == 0);
  const QuadMesh again = smoothed(patched(cleaned.mesh, fields, options), fields, options);
  INFO("clean-up, patches and smoothing");
  check_not_worse(quad_quality(again), before);
}

}  // namespace

TEST_CASE("finishing a finished mesh makes it no worse") {
  for (const DomainInput& input : {square(1, 0.06), l_shape(0.05), disc(0.07), annulus(0.07),
                                   plate_with_hole(0.06), hood(0.06)})
    check_again(input, {.keep_boundary = true});
  check_again(plate_with_hole(0.06), {.size = 0.05});
}

TEST_CASE("finishing a finished mesh keeps its one triangle") {
  DomainInput input = plate_with_hole(0.08);
  input.regions[0].loops[0].erase(input.regions[0].loops[0].begin() + 3);
  check_again(input, {.keep_boundary = true, .elements = Elements::one_triangle});
}

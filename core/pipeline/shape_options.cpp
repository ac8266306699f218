// See shape_options.h.
#include "pipeline/shape_options.h"

namespace lpq {
namespace {

constexpr int steps_before_patches = 20;
// Shares of Options::size_weight: of an edge's length (per edge and side), of a quad's area.
constexpr double edge_share = 0.5, area_share = 2;

}  // namespace

SmoothOptions shape_smoothing(const Options& options) {
  return {.size_weight = edge_share * options.size_weight,
          .area_weight = area_share * options.size_weight};
}

PatchOptions patch_options(const Options& options) {
  const SmoothOptions smoothing = shape_smoothing(options);
  PatchOptions patches;
  patches.seed = options.seed;
  patches.takes_triangles = options.elements == Elements::quad_dominant;
  patches.energy = {.size_weight = smoothing.size_weight,
                    .area_weight = smoothing.area_weight,
                    .rounding = coarse_rounding,
                    .floor_deviation = 1 - smoothing.eta_floor};
  return patches;
}

PatchOptions annealing_options(const Options& options) {
  PatchOptions patches = patch_options(options);
  patches.credit = 5;  // less than in order, and more fillings: chance has time for shapes
  patches.plans = 10;
  // Hot enough at first to part with what the ordered passes settled on: beginning at 0.8 leaves a
  // quarter more irregular vertices. Twice the trials gain nothing.
  patches.passes = {{.temperature = 8, .trials = 60},
                    {.temperature = 4, .trials = 80},
                    {.temperature = 2, .trials = 80},
                    {.temperature = 1, .trials = 80},
                    {.largest = 60},
                    {.largest = 200}};
  return patches;
}

CleanupOptions cleanup_before_patches(const Options& options) {
  CleanupOptions cleanup;
  cleanup.topology = true;
  cleanup.smoothing_iterations = steps_before_patches;
  cleanup.size_weight = edge_share * options.size_weight;
  cleanup.rounding = coarse_rounding;
  return cleanup;
}

}  // namespace lpq

// See rework.h.
#include "shell/rework.h"

#include <limits>
#include <utility>

#include "cleanup/cleanup.h"
#include "cleanup/ideal_valence.h"
#include "cleanup/shape_energy.h"
#include "mesh/quality.h"
#include "pipeline/shape_options.h"

namespace lpq {
namespace {

constexpr int smoothing_steps = 60;

/// What patches lower: energy and irregularity together.
double merit(const QuadMesh& mesh, const Fields& fields, const PatchOptions& options) {
  std::vector<Vec2> gradient(mesh.points.size());  // not asked for
  const Evaluation energy = eta_energy(
      mesh.faces, mesh.points, target_inverse_squares(mesh, fields), options.energy, gradient);
  if (energy.status != EvalStatus::ok) return std::numeric_limits<double>::infinity();
  const QuadTopology topology{QuadMesh(mesh)};
  return energy.value + options.credit * IdealValence(topology).total_weight(topology);
}

/// Chance first. Cooler than in the plane: a window is small, and its mesh good but where the cut
/// was.
PatchOptions search_options(const Options& options, std::uint64_t seed) {
  const double trials = options.effort == Effort::high ? 80 : 20;
  PatchOptions patches = annealing_options(options);
  patches.passes = {{.temperature = 0.8, .trials = trials},
                    {.temperature = 0.4, .trials = trials},
                    {.temperature = 0.2, .trials = trials},
                    {.largest = 60},
                    {.largest = 200}};
  patches.seed = seed;
  return patches;
}

QuadMesh remeshed(QuadMesh quads, const Fields& fields, const PatchOptions& patches,
                  SmoothOptions smoothing) {
  PatchRemesher remesher(std::move(quads), fields, patches);
  while (remesher.step(1000)) {
  }
  quads = remesher.mesh();
  smoothing.iterations = smoothing_steps;
  smooth_eta(quads, fields, smoothing);
  return quads;
}

}  // namespace

std::optional<QuadMesh> rework(const Window& window, Rework kind, const Options& options,
                               std::uint64_t seed) {
  const bool is_seam = kind == Rework::seam;
  const PatchOptions patches = is_seam ? patch_options(options) : search_options(options, seed);
  const Index bad_before = quad_quality(window.quads).nonconvex;
  QuadMesh quads = window.quads;
  if (is_seam || bad_before > 0)
    quads = clean_up(std::move(quads), window.fields, cleanup_before_patches(options)).mesh;
  quads = remeshed(std::move(quads), window.fields, patches, shape_smoothing(options));
  const bool better =
      is_seam ? quad_quality(quads).nonconvex <= bad_before
              : merit(quads, window.fields, patches) < merit(window.quads, window.fields, patches);
  if (!better) return std::nullopt;
  return quads;
}

}  // namespace lpq

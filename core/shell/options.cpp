// See options.h.
#include "shell/options.h"

namespace lpq {

Options chart_options(const SurfaceOptions& options) {
  Options planar;
  planar.keep_boundary = true;
  planar.method = options.method;
  planar.seeds = options.seeds;
  planar.norm = options.norm;
  planar.iterations = options.iterations;
  planar.restarts = options.restarts;
  planar.seed = options.seed;
  planar.growth = 1;  // the surface's sizes are limited already
  planar.size_weight = options.size_weight;
  planar.smoothing = options.smoothing;
  planar.max_elements = options.max_elements;
  return planar;
}

Options window_options(const SurfaceOptions& options) {
  Options planar = chart_options(options);
  planar.effort = options.effort;
  return planar;
}

}  // namespace lpq

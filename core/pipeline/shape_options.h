// One measure of shape for patches and the final smoothing, from the options of a run. Length and
// area terms together: lengths alone keep to the size at the expense of right angles, areas alone
// let quads become oblong.
#pragma once

#include "cleanup/cleanup.h"
#include "cleanup/smooth.h"
#include "patches/remesh.h"
#include "pipeline/options.h"

namespace lpq {

/// Rounding of the final smoothing after its first iterations, which have the coarse one.
inline constexpr double fine_rounding = 0.003;

SmoothOptions shape_smoothing(const Options& options);
PatchOptions patch_options(const Options& options);
/// What high effort adds, to a mesh that has been through those.
PatchOptions annealing_options(const Options& options);
/// Clean-up before patches: topology, and a few steps of smoothing.
CleanupOptions cleanup_before_patches(const Options& options);

}  // namespace lpq

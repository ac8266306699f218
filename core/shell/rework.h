// One window made better in its plane: clean-up, patches, smoothing; and the verdict.
#pragma once

#include <optional>

#include "pipeline/options.h"
#include "shell/window.h"

namespace lpq {

enum class Rework {
  seam,  // a cut went through: whatever comes out convex is better
  knot,  // irregular vertices that were left: only what is better, and chance helps to find it
};

/// The quads of the window as they should be; none where they should stay.
std::optional<QuadMesh> rework(const Window& window, Rework kind, const Options& options,
                               std::uint64_t seed);

}  // namespace lpq

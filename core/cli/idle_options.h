// Options on the command line that change nothing beside the others, told rather than passed over.
#pragma once

#include <vector>

#include "base/result.h"
#include "cli/args.h"
#include "cli/outputs.h"

namespace lpq {

/// A warning (code ignored) for each, of those that were given. `seeds_given`: the domain's file
/// has points to start from.
std::vector<Warning> idle_options(const RunFiles& files, const MeshArgs& args, bool seeds_given);

/// The same of a surface.
std::vector<Warning> idle_surface_options(const RunFiles& files, const MeshArgs& args);

}  // namespace lpq

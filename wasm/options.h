// A JavaScript object to an option struct, by its table.
#pragma once

#include <emscripten/val.h>

#include "base/result.h"
#include "io/mesh/mesh_format.h"
#include "pipeline/options.h"
#include "shell/options.h"

namespace lpq {

/// Members that are absent or undefined keep their defaults. Errors: bad_option, for a name that
/// does not exist (with the nearest one that does), a wrong type or choice.
Result<Options> options_from(const emscripten::val& object);
Result<SurfaceOptions> surface_options_from(const emscripten::val& object);
Result<MeshWriteOptions> write_options_from(const emscripten::val& object);

}  // namespace lpq

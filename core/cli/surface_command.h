// `lpquad mesh` where the input is a surface.
#pragma once

#include <string>

#include "base/monitor.h"
#include "base/result.h"
#include "cli/args.h"
#include "cli/outputs.h"

namespace lpq {

/// An option on the command line that has no meaning for this input: for domains alone, or for
/// surfaces alone. Code bad_option.
Problem misplaced_option(const RunFiles& files, const MeshArgs& args, bool is_surface);

/// Reads, meshes, writes; returns the report as text. Errors: those of the reader, of mesh_surface
/// and of write_file.
Result<std::string> mesh_surface_file(const RunFiles& files, const MeshArgs& args,
                                      const std::string& bytes, Monitor monitor);

}  // namespace lpq

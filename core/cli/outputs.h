// Which files each input becomes.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "cli/args.h"
#include "io/mesh/mesh_format.h"

namespace lpq {

struct RunFiles {
  std::string input;
  std::string output, report, stages, svg, uv;  // "" = not asked for
  MeshFormat format = MeshFormat::obj;          // of `output`
};

/// One entry per input. `{}` in a name becomes the input's name without folder and ending; an
/// output that is a folder gets <name>.obj. Errors: bad_option, where nothing is to be written, an
/// ending is unknown, two inputs would write the same file, or an input would be overwritten, also
/// by a file that is written into a folder of stages.
Result<std::vector<RunFiles>> plan_files(const MeshArgs& args);

}  // namespace lpq

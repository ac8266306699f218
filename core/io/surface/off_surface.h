// Geomview's OFF as a surface.
#pragma once

#include <string_view>

#include "base/result.h"
#include "surface/soup.h"

namespace lpq {

/// "OFF" with any of the prefixes ST, C, N, 4, or nothing at all before the counts, which may
/// follow on the same line; text only. One vertex or face on a line; what follows on it (normals,
/// colours) is passed over. Files that cannot be read so, and have no prefix, are read with their
/// vertices anyhow on lines, before faces that begin on lines of their own. Faces with fewer than
/// three corners are left out with a warning. Memory is bounded by the size of the text. Errors:
/// parse_error or non_finite with line and byte; empty without a face.
Result<SurfaceSoup> read_off_surface(std::string_view text);

}  // namespace lpq

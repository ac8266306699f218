// Wavefront OBJ: true quads, 17 digits, one group per region.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "io/mesh/output_parts.h"
#include "mesh/output_mesh.h"
#include "mesh/tri_mesh.h"

namespace lpq {

std::string write_obj(const OutputMesh& mesh);
/// A triangulation as it is, for looking at stages.
std::string write_obj(const TriMesh& mesh);

/// Reads v, f (three or four corners, negative indices, v/vt/vn; vertices may come after) and g
/// (regions); other lines are passed over, lines may go on after a backslash. Points no face uses
/// are dropped. A height other than 0 is taken in space only. Errors: parse_error with line and
/// byte.
Result<OutputMesh> read_obj(std::string_view text, MeshScope scope = MeshScope::plane);

}  // namespace lpq

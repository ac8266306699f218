// Mesh files by the ending of their names.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "io/msh.h"
#include "mesh/output_mesh.h"

namespace lpq {

enum class MeshFormat { obj, msh, vtu, svg, json };

inline constexpr std::string_view mesh_endings = ".obj, .msh, .vtu, .svg or .json";

/// By the file name's ending, upper or lower case.
std::optional<MeshFormat> mesh_format(std::string_view file_name);

std::string write_mesh(const OutputMesh& mesh, MeshFormat format,
                       MshVersion version = MshVersion::v4_1);

/// .obj and .msh only; the others give a parse_error that says so.
Result<OutputMesh> read_mesh(std::string_view text, MeshFormat format);

}  // namespace lpq

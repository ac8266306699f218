// The element kinds of .msh files, by their numbers (Gmsh reference manual, "MSH file format").
#pragma once

#include <cstdint>

#include "base/result.h"
#include "io/mesh/msh_parse.h"
#include "io/mesh/output_parts.h"

namespace lpq {

inline constexpr std::int64_t msh_quad = 3;  // the greatest of first order that is read, but points

/// Corners of the element kinds that are read, 0 for others. Gmsh lists corners first.
int msh_corners(std::int64_t type, MeshScope scope);

/// All nodes of an element of any kind, which take their place in binary files; 0 where that is not
/// known, or differs.
int msh_nodes(std::int64_t type);

/// "a tetrahedron", of kinds that are not read everywhere.
const char* msh_type_name(std::int64_t type);
bool is_msh_volume(std::int64_t type);
/// A triangle or quad of third order or higher, which is not read at all.
bool is_msh_high_face(std::int64_t type);

/// Of a file without a triangle or quad: what it has instead, and what to do. Code empty.
Error error_of_no_face(const MshContent& content);

}  // namespace lpq

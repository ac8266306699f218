// Gmsh's MSH file format (Gmsh reference manual, "MSH file format"); written are versions 4.1 and
// 2.2, ASCII.
// Regions become surfaces, with one physical surface for each name; the 1D mesh is written as line
// elements, one curve for each run of edges with equal regions, tag and loop, and one physical
// curve for each name; tagged points become point elements with physical names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/option_table.h"
#include "base/result.h"
#include "io/mesh/output_parts.h"
#include "mesh/output_mesh.h"

namespace lpq {

enum class MshVersion { v4_1, v2_2 };
template <>
struct ChoiceNames<MshVersion> {
  static constexpr std::array<const char*, 2> names{"4.1", "2.2"};
};

std::string write_msh(const OutputMesh& mesh, MshVersion version = MshVersion::v4_1);

/// Reads nodes, points, lines, triangles and quads with their physical names, versions 2.0 - 2.2,
/// 4.0 and 4.1, ASCII or binary. Nodes that no face uses are dropped. Elements of other kinds (also
/// second order) are an error: they would be silently left out. Memory is bounded by the size of
/// the file, whatever counts it claims. In space any height is taken, and elements of second order
/// are their corners. Errors: parse_error with byte, and of ASCII with line.
Result<OutputMesh> read_msh(std::string_view text, MeshScope scope = MeshScope::plane);

struct MshElements {
  OutputMesh mesh;
  std::vector<Warning> warnings;  // of groups that the mesh cannot hold
};

/// The same without its last two steps: a file of lines alone is good, and every node is kept.
/// Of elements that are there again for another physical group the first is taken.
Result<MshElements> read_msh_elements(std::string_view text);

}  // namespace lpq

// Domains from Gmsh's MSH files, versions 2.0 - 2.2, 4.0 and 4.1, ASCII or binary (Gmsh reference
// manual, "MSH file format"). With triangles or quads: the boundary of each group of faces
// (physical surface, else elementary surface) is a region of its name; line elements give tags to
// edges, and stay as polylines inside a region; points with a physical name inside become tagged
// points. Of several physical groups the first counts, with a warning; parts of a partitioned mesh
// belong to their wholes. Without faces the lines alone are the outlines, under the even-odd rule
// as in svg_domain.h.
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/domain/domain_file.h"

namespace lpq {

/// Errors: parse_error with line and byte, also for other versions, for an open outline and for
/// faces that overlap (with the point); empty.
Result<DomainFile> read_msh_domain(std::string_view text);

}  // namespace lpq

// Nastran bulk data (.bdf, .nas). Format: NX Nastran quick reference guide, "Bulk data entries":
// fields of 8 characters, or of 16 in large field entries.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/output_mesh.h"

namespace lpq {

/// GRID* with the best 16 characters of each coordinate (13 to 15 digits), CQUAD4 and CTRIA3 with
/// one property number per name of regions, the 1D mesh as CROD - of all line elements it is the
/// one that needs no orientation and that readers know - with one property number per name, and a
/// SET1 for each name of tagged points. Names stand in comments. No property or material is
/// written.
std::string write_bdf(const OutputMesh& mesh);

/// One entry of integers, with its continuation lines; in large fields where an integer has more
/// than 8 digits.
void append_bdf_entry(std::string& out, std::string_view name,
                      const std::vector<std::int64_t>& fields);

}  // namespace lpq

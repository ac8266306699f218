// Domains from the .poly files of Triangle (J. R. Shewchuk, "Triangle: a two-dimensional quality
// mesh generator", file formats .node and .poly). As in Triangle, what segments enclose is
// material unless a hole point lies in it; segments that divide it make neighbouring regions,
// other segments inside become polylines, vertices without segments points. A marker m other than 0
// becomes the tag "marker m"; the attribute a of a region becomes the name "region a" of the face
// its point lies in. Told are points that have no effect, and vertices on segments, which are left
// out. Attributes of vertices are ignored, area limits with a warning.
// Unlike Triangle with -c, the convex hull is not taken: the outline must consist of segments.
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/domain/domain_file.h"

namespace lpq {

/// Errors: parse_error with line and byte (also for a file whose vertices are in a .node file of
/// their own), empty.
Result<DomainFile> read_poly_domain(std::string_view text);

}  // namespace lpq

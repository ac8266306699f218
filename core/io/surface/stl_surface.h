// STL, as text and as bytes, as a surface.
#pragma once

#include <string_view>

#include "base/result.h"
#include "surface/soup.h"

namespace lpq {

/// Bytes if the size is what the count of facets says, whatever the header begins with; else text
/// if it begins with "solid"; else bytes. Points are not welded; facet normals and attribute bytes
/// are passed over. Every solid of a text is a group. Errors: parse_error or non_finite with the
/// byte, for texts also the line; empty without a facet.
Result<SurfaceSoup> read_stl_surface(std::string_view bytes);

/// Whether the bytes are as many as the count of facets in them says.
bool is_binary_stl(std::string_view bytes);

}  // namespace lpq

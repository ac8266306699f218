// The basic shapes of SVG and <path> (W3C, SVG 1.1, chapters 8 and 9).
#pragma once

#include <string_view>
#include <vector>

#include "io/domain/svg_path.h"
#include "io/domain/xml_reader.h"

namespace lpq {

/// The error for what is wrong in an attribute of the tag that `xml` read last.
Error attribute_error(std::string_view text, const XmlReader& xml, const XmlAttribute& attribute,
                      const AttributeProblem& problem);

/// Appends what the tag that `xml` read last draws, in its own coordinates; nothing for elements
/// that are no shapes. `text` is all that is read. Errors: parse_error with its place.
Problem read_svg_shape(std::string_view text, const XmlReader& xml, std::vector<Subpath>& subpaths);

}  // namespace lpq

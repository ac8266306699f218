// The basic shapes of SVG and <path> (W3C, SVG 1.1, chapters 8 and 9).
#pragma once

#include <string_view>
#include <vector>

#include "io/domain/svg_path.h"
#include "io/domain/svg_style.h"
#include "io/domain/xml_reader.h"

namespace lpq {

/// The error for what is wrong in an attribute of the tag that `xml` read last.
Error attribute_error(std::string_view text, const XmlReader& xml, const XmlAttribute& attribute,
                      const AttributeProblem& problem);

/// A length of that tag, of a style or an attribute; nothing where none is said, or "auto", or what
/// is said is wrong, which goes into `problem`.
std::optional<double> find_svg_length(const XmlReader& xml, const StyleSheet& sheet,
                                      const LengthUnits& units, std::string_view name,
                                      MaybeProblem& problem);
/// The error for that problem, with its place.
Error svg_length_error(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
                       std::string_view name, const AttributeProblem& problem);

/// Appends what the tag that `xml` read last draws, in its own coordinates; nothing for elements
/// that are no shapes. `text` is all that is read. Errors: parse_error with its place.
Problem read_svg_shape(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
                       const LengthUnits& units, std::vector<Subpath>& subpaths);

}  // namespace lpq

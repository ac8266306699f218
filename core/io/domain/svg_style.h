// Properties of SVG elements, from attributes and style attributes.
#pragma once

#include <string>
#include <string_view>

#include "io/domain/xml_reader.h"

namespace lpq {

/// An attribute of the tag that `xml` read last, without blanks around it; "" if it has none.
std::string svg_attribute(const XmlReader& xml, std::string_view name);

/// A property of that tag: of its style attribute, else the attribute of that name; "" if neither
/// says anything.
std::string svg_property(const XmlReader& xml, std::string_view name);

}  // namespace lpq

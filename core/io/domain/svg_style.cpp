// See svg_style.h.
#include "io/domain/svg_style.h"

#include <algorithm>

namespace lpq {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The value of a property in "fill: none; stroke: #000"; the last one counts.
std::string_view style_value(std::string_view style, std::string_view property) {
  std::string_view value;
  while (!style.empty()) {
    const std::string_view one = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(one.size() + 1, style.size()));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos || trimmed(one.substr(0, colon)) != property) continue;
    value = trimmed(one.substr(colon + 1));
    const std::size_t important = value.find('!');
    if (important != std::string_view::npos) value = trimmed(value.substr(0, important));
  }
  return value;
}

}  // namespace

std::string svg_attribute(const XmlReader& xml, std::string_view name) {
  const XmlAttribute* attribute = xml.find(name);
  return attribute == nullptr ? "" : std::string(trimmed(xml_value(attribute->raw)));
}

std::string svg_property(const XmlReader& xml, std::string_view name) {
  if (const XmlAttribute* style = xml.find("style")) {
    const std::string text = xml_value(style->raw);
    const std::string_view value = style_value(text, name);
    if (!value.empty()) return std::string(value);
  }
  return svg_attribute(xml, name);
}

}  // namespace lpq

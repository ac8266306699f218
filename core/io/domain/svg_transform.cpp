// See svg_transform.h.
#include "io/domain/svg_transform.h"

#include <algorithm>
#include <utility>

#include "io/domain/svg_shapes.h"

namespace lpq {
namespace {

bool is_horizontal(std::string_view word) { return word == "left" || word == "right"; }
bool is_vertical(std::string_view word) { return word == "top" || word == "bottom"; }

/// The words for places as lengths.
std::string_view length_of(std::string_view word) {
  if (word == "left" || word == "top") return "0";
  if (word == "right" || word == "bottom") return "100%";
  return word == "center" ? "50%" : word;
}

/// "20 30", "left", "50% 10px"; false for what is none of these.
bool read_origin(std::string_view text, const LengthUnits& units, Vec2& origin) {
  const auto take_word = [&text] {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size());
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return word;
  };
  std::string_view x = take_word(), y = take_word();
  if (y.empty()) y = "center";
  if (is_vertical(x) || is_horizontal(y)) std::swap(x, y);
  return !read_length(length_of(x), origin.x, units, LengthAxis::x) &&
         !read_length(length_of(y), origin.y, units, LengthAxis::y);
}

}  // namespace

Problem apply_svg_transform(std::string_view text, const XmlReader& xml, const StyleSheet& sheet,
                            const LengthUnits& units, Affine& map, Counter& not_applied) {
  const std::string styled = styled_property(xml, sheet, "transform");
  const XmlAttribute* attribute = xml.find("transform");
  if (styled.empty() && attribute == nullptr) return std::nullopt;
  Affine own;
  if (!styled.empty()) {
    if (read_transform(styled, own)) {
      not_applied.add("transform of a style");
      return std::nullopt;
    }
  } else if (const auto problem = read_transform(xml_value(attribute->raw), own)) {
    return attribute_error(text, xml, *attribute, *problem);
  }
  Vec2 origin;
  const std::string about = svg_property(xml, sheet, "transform-origin");
  if (!about.empty() && !read_origin(about, units, origin)) not_applied.add("transform-origin");
  const std::string box = svg_property(xml, sheet, "transform-box");
  if (!box.empty() && box != "view-box") not_applied.add("transform-box");
  const bool is_moved = !(origin == Vec2{});
  if (is_moved) map = map * Affine{1, 0, 0, 1, origin.x, origin.y};
  map = map * own;
  if (is_moved) map = map * Affine{1, 0, 0, 1, -origin.x, -origin.y};
  return std::nullopt;
}

}  // namespace lpq

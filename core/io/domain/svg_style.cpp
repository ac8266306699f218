// See svg_style.h.
#include "io/domain/svg_style.h"

#include <algorithm>

#include "base/sort_unique.h"
#include "io/plain_text.h"

namespace lpq {
namespace {

constexpr std::string_view blanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text) { return lpq::trimmed(text, blanks); }

/// The text before the separator, which is taken away with it.
std::string_view take_until(std::string_view& text, char separator) {
  const std::string_view one = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(one.size() + 1, text.size()));
  return one;
}

/// The value of a property in "fill: none; stroke: #000"; the last one counts.
std::string_view style_value(std::string_view style, std::string_view property) {
  std::string_view value;
  while (!style.empty()) {
    const std::string_view one = take_until(style, ';');
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos || trimmed(one.substr(0, colon)) != property) continue;
    value = trimmed(one.substr(colon + 1));
    value = trimmed(value.substr(0, value.find('!')));
  }
  return value;
}

/// Without what encloses it: comments of CSS, and the marks of CDATA and of XML comments.
std::string plain_css(std::string_view text) {
  std::string css;
  while (!text.empty()) {
    const auto skip = [&text](std::string_view mark) {
      if (text.substr(0, mark.size()) != mark) return false;
      text.remove_prefix(mark.size());
      return true;
    };
    if (skip("/*")) {
      const std::size_t end = text.find("*/");
      text = end == std::string_view::npos ? std::string_view() : text.substr(end + 2);
    } else if (!skip("<![CDATA[") && !skip("]]>") && !skip("<!--") && !skip("-->")) {
      css += text[0];
      text.remove_prefix(1);
    }
  }
  return css;
}

/// From behind a '{' to behind its '}'.
std::string_view take_block(std::string_view& text) {
  std::size_t depth = 1, i = 0;
  for (; i < text.size() && depth > 0; ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}') --depth;
  }
  const std::string_view block = text.substr(0, depth == 0 ? i - 1 : i);
  text.remove_prefix(i);
  return block;
}

}  // namespace

std::string svg_attribute(const XmlReader& xml, std::string_view name) {
  const XmlAttribute* attribute = xml.find(name);
  return attribute == nullptr ? "" : std::string(trimmed(xml_value(attribute->raw)));
}

StyleSheet::StyleSheet(std::string_view svg) {
  if (svg.find("<style") == std::string_view::npos && svg.find(":style") == std::string_view::npos)
    return;
  XmlReader xml(svg);  // what is wrong in the text is said where it is read
  std::size_t end = 0;
  for (auto event = xml.next(); event == XmlReader::Event::open || event == XmlReader::Event::close;
       event = xml.next()) {
    if (event != XmlReader::Event::open || xml.name() != "style") continue;
    const std::string type = svg_attribute(xml, "type");
    if ((!type.empty() && type != "text/css") || xml.closes_itself()) continue;
    if (xml.position() < end) continue;  // in one that is read: few bytes are not to become many
    end = std::min(svg.find("</", xml.position()), svg.size());
    texts_.push_back(plain_css(svg.substr(xml.position(), end - xml.position())));
  }
  for (const std::string& text : texts_) read(text);
}

void StyleSheet::read(std::string_view css) {
  while (true) {
    css.remove_prefix(std::min(css.find_first_not_of(blanks), css.size()));
    if (css.empty()) return;
    const bool at_rule = css[0] == '@';
    const std::size_t end = std::min(css.find_first_of(at_rule ? ";{" : "{"), css.size());
    const bool is_statement = end < css.size() && css[end] == ';';  // @import
    const std::string_view selectors = css.substr(0, end);
    css.remove_prefix(std::min(end + 1, css.size()));
    if (is_statement) continue;
    const std::string_view block = take_block(css);
    if (!at_rule) add_rules(selectors, block);
  }
}

void StyleSheet::add_rules(std::string_view selectors, std::string_view declarations) {
  Rule rule;
  bool says_something = false, says_more = false;
  for (std::size_t i = 0; i < sheet_properties.size(); ++i) {
    rule.values[i] = style_value(declarations, sheet_properties[i]);
    if (rule.values[i].empty()) continue;
    says_something = true;
    says_more = says_more || sheet_properties[i] != "font-size";  // which is for text, mostly
  }
  if (!says_something) return;
  while (!selectors.empty()) {
    Rule own = rule;
    if (!read_selector(trimmed(take_until(selectors, ',')), own)) {
      if (says_more) ++unread_;
      continue;
    }
    own.order = count_++;
    for (std::size_t i = 0; i < is_said_.size(); ++i) is_said_[i] |= !own.values[i].empty();
    std::string key(own.tag);
    if (!own.classes.empty()) key = "." + std::string(own.classes[0]);
    if (!own.id.empty()) key = "#" + std::string(own.id);
    rules_[key].push_back(std::move(own));
  }
}

/// "circle", "*", ".hidden", "#a", "path.hidden.thin#a"; anything else is none of them.
bool StyleSheet::read_selector(std::string_view selector, Rule& rule) {
  if (selector.empty() || selector.find_first_of(" \t\r\n\f>+~:[]()\"'") != std::string_view::npos)
    return false;
  const auto take_name = [&selector](std::size_t from) {
    const std::size_t end = std::min(selector.find_first_of(".#", from), selector.size());
    const std::string_view name = selector.substr(from, end - from);
    selector.remove_prefix(end);
    return name;
  };
  rule.tag = take_name(0);
  rule.weight = rule.tag.empty() || rule.tag == "*" ? 0 : 1;
  if (rule.tag.empty()) rule.tag = "*";
  while (!selector.empty()) {
    const bool is_class = selector[0] == '.';
    const std::string_view name = take_name(1);
    if (name.empty() || (!is_class && !rule.id.empty())) return false;
    if (is_class) {
      rule.classes.push_back(name);
    } else {
      rule.id = name;
    }
    rule.weight += is_class ? 1000 : 1'000'000;
  }
  return true;
}

bool StyleSheet::applies(const Rule& rule, const Element& element) {
  const auto& classes = element.classes;
  return (rule.tag == "*" || rule.tag == element.tag) &&
         (rule.id.empty() || rule.id == element.id) &&
         std::all_of(rule.classes.begin(), rule.classes.end(), [&](std::string_view name) {
           return std::binary_search(classes.begin(), classes.end(), name);
         });
}

std::string_view StyleSheet::value(const XmlReader& xml, std::string_view property) const {
  const auto which = static_cast<std::size_t>(
      std::find(sheet_properties.begin(), sheet_properties.end(), property) -
      sheet_properties.begin());
  if (which == sheet_properties.size() || !is_said_[which]) return {};
  const std::string id = svg_attribute(xml, "id"), listed = svg_attribute(xml, "class");
  Element element{xml.name(), id, {}};
  std::vector<std::string> keys{"#" + id, std::string(xml.name()), "*"};
  for (std::string_view rest = listed; !rest.empty();) {
    const std::string_view name = take_until(rest, ' ');  // xml_value made all blanks this one
    if (!name.empty()) element.classes.push_back(name);
  }
  sort_unique(element.classes);
  for (const std::string_view name : element.classes) keys.push_back("." + std::string(name));
  const Rule* best = nullptr;
  for (const std::string& key : keys) {
    const auto found = rules_.find(key);
    if (found == rules_.end()) continue;
    for (const Rule& rule : found->second)
      if (!rule.values[which].empty() && applies(rule, element) &&
          (best == nullptr ||
           std::pair(rule.weight, rule.order) > std::pair(best->weight, best->order)))
        best = &rule;
  }
  return best == nullptr ? std::string_view() : best->values[which];
}

std::string styled_property(const XmlReader& xml, const StyleSheet& sheet, std::string_view name) {
  if (const XmlAttribute* style = xml.find("style")) {
    const std::string text = xml_value(style->raw);
    const std::string_view value = style_value(text, name);
    if (!value.empty()) return std::string(value);
  }
  return std::string(sheet.value(xml, name));
}

std::string svg_property(const XmlReader& xml, const StyleSheet& sheet, std::string_view name) {
  std::string styled = styled_property(xml, sheet, name);
  return styled.empty() ? svg_attribute(xml, name) : styled;
}

}  // namespace lpq

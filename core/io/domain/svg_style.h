// Properties of SVG elements: from style attributes, style sheets and attributes of their own
// (W3C, SVG 1.1, chapter 6; CSS 2.1, chapters 5 and 6.4).
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.h"
#include "io/domain/xml_reader.h"

namespace lpq {

/// An attribute of the tag that `xml` read last, without blanks around it; "" if it has none.
std::string svg_attribute(const XmlReader& xml, std::string_view name);

/// What may be asked for of a style sheet.
inline constexpr std::array<std::string_view, 20> sheet_properties{"display",
                                                                   "visibility",
                                                                   "fill",
                                                                   "fill-rule",
                                                                   "transform",
                                                                   "transform-origin",
                                                                   "transform-box",
                                                                   "clip-path",
                                                                   "mask",
                                                                   "font-size",
                                                                   "d",
                                                                   "x",
                                                                   "y",
                                                                   "width",
                                                                   "height",
                                                                   "cx",
                                                                   "cy",
                                                                   "r",
                                                                   "rx",
                                                                   "ry"};

/// The <style> elements of a document. Rules apply whose selectors are a name of an element, *,
/// classes, ids or these in one, as in "path.hidden"; others are counted. Blocks of @-rules are
/// passed over.
class StyleSheet {
 public:
  explicit StyleSheet(std::string_view svg);
  StyleSheet(const StyleSheet&) = delete;
  StyleSheet& operator=(const StyleSheet&) = delete;

  /// Of the tag read last, "" where no rule says anything: of the rule with the most special
  /// selector, the last of equals; "" also for what is none of sheet_properties.
  std::string_view value(const XmlReader& xml, std::string_view property) const;
  /// Rules about such a property that do not apply because of their selectors.
  Index unread() const { return unread_; }

 private:
  struct Rule {
    std::string_view tag, id;
    std::vector<std::string_view> classes;
    std::array<std::string_view, sheet_properties.size()> values;
    int weight = 0;
    Index order = 0;
  };

  struct Element {
    std::string_view tag, id;
    std::vector<std::string_view> classes;  // in order, each once
  };

  void read(std::string_view css);
  void add_rules(std::string_view selectors, std::string_view declarations);
  static bool read_selector(std::string_view selector, Rule& rule);
  static bool applies(const Rule& rule, const Element& element);

  std::vector<std::string> texts_;                               // what the rules point into
  std::map<std::string, std::vector<Rule>, std::less<>> rules_;  // by "#id", ".class", tag or "*"
  std::array<char, sheet_properties.size()> is_said_{};          // of each property: by any rule
  Index count_ = 0, unread_ = 0;
};

/// A property of that tag: of its style attribute, else of the sheet; "" if neither says anything.
std::string styled_property(const XmlReader& xml, const StyleSheet& sheet, std::string_view name);
/// That, else the attribute of that name, else "".
std::string svg_property(const XmlReader& xml, const StyleSheet& sheet, std::string_view name);

}  // namespace lpq

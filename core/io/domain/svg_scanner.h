// The characters of SVG attributes, one word or number after another.
#pragma once

#include <string_view>

#include "geometry/vec.h"
#include "io/number.h"
#include "io/plain_text.h"

namespace lpq {

/// Numbers as SVG packs them: "1-2.5.5e3" is 1, -2.5, .5e3.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool at_end() { return peek() == '\0' && at_ >= text_.size(); }
  /// The next character that is not a separator, '\0' at the end.
  char peek() {
    while (at_ < text_.size() && is_separator(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  char take() {
    const char c = peek();
    if (at_ < text_.size()) ++at_;
    return c;
  }
  bool starts_number() {
    const char c = peek();
    return is_digit(c) || c == '.' || c == '-' || c == '+';
  }
  bool number(double& value) {
    peek();
    const std::size_t start = at_;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    digits();
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      digits();
    }
    exponent();
    if (parse_number(text_.substr(start, at_ - start), value)) return true;
    at_ = start;
    return false;
  }
  bool point(Vec2& p) { return number(p.x) && number(p.y); }
  /// Flags of arcs are one character and need no separator.
  bool flag(bool& value) {
    const char c = peek();
    if (c != '0' && c != '1') return false;
    ++at_;
    value = c == '1';
    return true;
  }
  std::string_view word() {
    peek();
    const std::size_t start = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

 private:
  static bool is_separator(char c) {
    return c == ' ' || c == ',' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
  }
  void digits() {
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }
  void exponent() {
    if (at_ >= text_.size() || (text_[at_] != 'e' && text_[at_] != 'E')) return;
    std::size_t next = at_ + 1;
    if (next < text_.size() && (text_[next] == '-' || text_[next] == '+')) ++next;
    if (next >= text_.size() || !is_digit(text_[next])) return;  // "1em", "1e"
    at_ = next;
    digits();
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace lpq

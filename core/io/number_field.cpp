// See number_field.h.
#include "io/number_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/number.h"

namespace lpq {
namespace {

/// 0.d1d2d3... * 10^point, without zeros at either end.
struct Decimal {
  std::string digits;
  std::int64_t point = 0;
};

/// From printf's %e or append_number, whatever the locale's decimal point is.
Decimal split(std::string_view text) {
  Decimal decimal;
  const std::string_view mantissa = text.substr(0, text.find('e'));
  bool whole = true;
  for (const char c : mantissa) {
    if (c < '0' || c > '9') {
      whole = false;
      continue;
    }
    decimal.digits += c;
    if (whole) ++decimal.point;
  }
  std::int64_t exponent = 0;
  if (mantissa.size() < text.size()) parse_integer(text.substr(mantissa.size() + 1), exponent);
  const std::size_t zeros = std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size());
  decimal.digits.erase(0, zeros);
  decimal.point += exponent - static_cast<std::int64_t>(zeros);
  decimal.digits.erase(decimal.digits.find_last_not_of('0') + 1);
  if (decimal.digits.empty()) decimal.point = 1;
  return decimal;
}

Decimal rounded(double value, std::size_t digits) {
  char text[48];
  const int length = std::snprintf(text, sizeof text, "%.*e", static_cast<int>(digits) - 1, value);
  return split({text, static_cast<std::size_t>(length)});
}

std::string fixed(const Decimal& decimal) {
  const auto size = static_cast<std::int64_t>(decimal.digits.size());
  const auto whole = static_cast<std::size_t>(std::clamp(decimal.point, std::int64_t{0}, size));
  std::string text = decimal.digits.substr(0, whole);
  if (decimal.point > size) text.append(static_cast<std::size_t>(decimal.point - size), '0');
  text += '.';
  if (decimal.point < 0) text.append(static_cast<std::size_t>(-decimal.point), '0');
  text += decimal.digits.substr(whole);
  return text;
}

std::string scientific(const Decimal& decimal, std::string_view exponent_mark) {
  std::string text(1, decimal.digits[0]);
  text += '.';
  text += decimal.digits.substr(1);
  text += exponent_mark;
  if (exponent_mark.empty() && decimal.point > 0) text += '+';
  append_integer(text, decimal.point - 1);
  return text;
}

}  // namespace

void append_number_field(std::string& out, double value, std::size_t width,
                         std::string_view exponent_mark) {
  if (!std::isfinite(value)) return append_number(out, value);
  if (std::signbit(value)) {
    out += '-';
    --width;
  }
  std::string text;
  append_number(text, std::fabs(value));
  Decimal decimal = split(text);
  constexpr std::int64_t longest_fixed = 25;  // longer ones fit no column
  for (std::size_t digits = decimal.digits.size();; decimal = rounded(std::fabs(value), --digits)) {
    const bool small = decimal.point > -longest_fixed && decimal.point < longest_fixed;
    if (digits > 0) text = scientific(decimal, exponent_mark);
    if (small) {
      const std::string other = fixed(decimal);
      if (digits == 0 || other.size() <= text.size()) text = other;
    }
    if (text.size() <= width) break;
  }
  if (text.back() == '.' && text.size() < width) text += '0';
  if (text[0] == '.' && text.size() < width) out += '0';
  out += text;
}

}  // namespace lpq

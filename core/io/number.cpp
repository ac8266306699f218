// See number.h. std::to_chars for double is missing in one of the supported standard libraries, so
// printf and strtod do the work, with the locale's decimal point translated on the way.
#include "io/number.h"

#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "io/plain_text.h"

namespace lpq {
namespace {

/// Exact short decimals: value = n / 10^k with |n| < 2^53 and k <= 6. Both n and 10^k are exact
/// doubles, so the correctly rounded quotient n / 10^k is what every reader makes of the digits.
bool append_short(std::string& out, double value) {
  constexpr std::array<double, 7> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
  constexpr double exact_integers = 0x1p53;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    const double scaled = std::floor(value * powers[k] + 0.5);
    if (!(scaled < exact_integers)) return false;
    if (scaled / powers[k] != value) continue;
    char digits[24];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, static_cast<std::int64_t>(scaled));
    std::string_view text(digits, static_cast<std::size_t>(end.ptr - digits));
    if (k == 0) {
      out += text;
      return true;
    }
    if (text.size() > k) {
      out += text.substr(0, text.size() - k);
      text.remove_prefix(text.size() - k);
    } else {
      out += '0';
    }
    out += '.';
    out.append(k - text.size(), '0');
    out += text;
    return true;
  }
  return false;
}

/// Everything that is not part of a number is the locale's decimal point, of one byte or more.
void append_with_plain_point(std::string& out, std::string_view text) {
  bool in_point = false;
  for (const char c : text) {
    if (is_digit(c) || c == '-' || c == '+' || c == 'e') {
      out += c;
      in_point = false;
    } else if (!in_point) {
      out += '.';
      in_point = true;
    }
  }
}

/// [+-] digits [. digits] [e [+-] digits] with a digit on at least one side of the point.
bool is_decimal(std::string_view text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t start = i;
    while (i < text.size() && is_digit(text[i])) ++i;
    return i - start;
  };
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  std::size_t mantissa = digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    mantissa += digits();
  }
  if (mantissa == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (digits() == 0) return false;
  }
  return i == text.size();
}

}  // namespace

void append_number(std::string& out, double value) {
  if (std::isnan(value)) {
    out += "nan";
    return;
  }
  if (std::signbit(value)) out += '-';
  value = std::fabs(value);
  if (std::isinf(value)) {
    out += "inf";
    return;
  }
  if (append_short(out, value)) return;
  char text[48];
  const int length = std::snprintf(text, sizeof text, "%.17g", value);
  append_with_plain_point(out, {text, static_cast<std::size_t>(length)});
}

void append_integer(std::string& out, std::int64_t value) {
  char digits[24];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, end.ptr);
}

void append_numbers(std::string& out, std::initializer_list<double> values) {
  for (const double* value = values.begin(); value != values.end(); ++value) {
    if (value != values.begin()) out += ' ';
    append_number(out, *value);
  }
}

void append_fixed(std::string& out, double value, int decimals) {
  if (!(std::fabs(value) < 1e9)) value = 0;  // also NaN: a picture has no place for it
  std::int64_t power = 1;
  for (int k = 0; k < decimals; ++k) power *= 10;
  auto scaled = static_cast<std::int64_t>(std::floor(value * static_cast<double>(power) + 0.5));
  if (scaled < 0) {
    out += '-';
    scaled = -scaled;
  }
  append_integer(out, scaled / power);
  std::int64_t rest = scaled % power;
  if (rest == 0) return;
  out += '.';
  for (power /= 10; rest != 0; rest %= power, power /= 10) {
    out += static_cast<char>('0' + rest / power);
    if (power == 1) break;
  }
}

bool parse_number(std::string_view text, double& value) {
  if (!is_decimal(text)) return false;
  std::string copy;  // strtod wants a terminating zero and the locale's decimal point
  copy.reserve(text.size() + 4);
  const char* point = std::localeconv()->decimal_point;
  for (const char c : text) {
    if (c == '.') {
      copy += point;
    } else {
      copy += c;
    }
  }
  char* end = nullptr;
  value = std::strtod(copy.c_str(), &end);
  return end == copy.c_str() + copy.size() && std::isfinite(value);
}

bool parse_integer(std::string_view text, std::int64_t& value) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return false;
  }
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

}  // namespace lpq

// What readers and writers look for in plain text: ASCII letters whatever their case, the ending of
// a file's name, blanks and marks around words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lpq {

// Of ASCII only: the C library's own follow the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string lower_case(std::string text);

/// Whether two words differ in nothing but capitals and small letters.
bool same_letters(std::string_view a, std::string_view b);

/// What follows the last point: "a/b.tar.gz" -> "gz"; empty where there is no point.
std::string_view ending_of(std::string_view file_name);

/// The bytes of the byte order mark that the text begins with: 3, or 0 for none.
std::size_t byte_order_mark_size(std::string_view text);

/// Without the blanks and line ends that it begins with.
std::string_view past_blanks(std::string_view text);

/// Without those of the characters `blanks` that it begins and ends with.
std::string_view trimmed(std::string_view text, std::string_view blanks);

}  // namespace lpq

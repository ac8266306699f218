// See dxf_names.h.
#include "io/domain/dxf_names.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "io/escape.h"
#include "io/plain_text.h"

namespace lpq {
namespace {

/// Bytes 0x80 .. 0x9F of ANSI_1252; the rest is as in Unicode.
constexpr std::array<std::uint32_t, 32> letters_1252{
    0x20AC, 0x81,   0x201A, 0x192,  0x201E, 0x2026, 0x2020, 0x2021, 0x2C6,  0x2030, 0x160,
    0x2039, 0x152,  0x8D,   0x17D,  0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x2DC,  0x2122, 0x161,  0x203A, 0x153,  0x9D,   0x17E,  0x178};

/// Of the \U+00C4 that the text begins with.
std::optional<std::uint32_t> code_of(std::string_view text) {
  if (text.size() < 7 || !same_letters(text.substr(0, 3), "\\U+")) return std::nullopt;
  std::uint32_t code = 0;
  const char* end = text.data() + 7;
  const auto read = std::from_chars(text.data() + 3, end, code, 16);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return code;
}

void append_byte(std::string& out, char c, DxfLetters letters) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte < 0x80 || letters == DxfLetters::utf8) {
    out += c;
  } else if (letters == DxfLetters::unknown) {
    out += '?';
  } else {
    append_character(out, byte < 0xA0 ? letters_1252[byte - 0x80] : byte);
  }
}

}  // namespace

DxfLetters dxf_letters(std::string_view text, std::string_view code_page) {
  if (is_utf8(text)) return DxfLetters::utf8;
  for (const std::string_view known : {"", "ANSI_1252", "ISO8859-1", "ISO_8859-1"})
    if (same_letters(code_page, known)) return DxfLetters::ansi_1252;
  return DxfLetters::unknown;
}

std::string dxf_name(std::string_view name, DxfLetters letters) {
  std::string text;
  while (!name.empty()) {
    if (auto code = code_of(name)) {
      name.remove_prefix(7);
      // Characters beyond 16 bits are written as two halves.
      const auto low = code_of(name);
      if (*code >= 0xD800 && *code < 0xDC00 && low && *low >= 0xDC00 && *low < 0xE000) {
        name.remove_prefix(7);
        code = 0x10000 + ((*code - 0xD800) << 10) + (*low - 0xDC00);
      }
      const bool is_character = *code >= 0x20 && (*code < 0xD800 || *code >= 0xE000);
      append_character(text, is_character ? *code : 0xFFFD);
    } else {
      append_byte(text, name.front(), letters);
      name.remove_prefix(1);
    }
  }
  return text;
}

}  // namespace lpq

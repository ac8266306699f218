// Places in a text, for errors.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace lpq {

/// An error at a byte of the text, with its line. Cost: the bytes before it.
inline Error error_at(std::string_view text, std::size_t byte, std::string message,
                      ErrorCode code = ErrorCode::parse_error) {
  byte = std::min(byte, text.size());
  Error error{code, std::move(message), {}};
  error.where.byte = static_cast<std::int64_t>(byte);
  // Where no line ends with LF, as in files of old Macs, they end with CR.
  const char end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  error.where.line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), end);
  return error;
}

/// The refusal of text that has two bytes a character, as some editors on Windows save it (or
/// four): told by its byte order mark, or by first characters that are half a zero.
inline Problem refuse_utf16(std::string_view text) {
  constexpr std::size_t looked_at = 8;
  const std::string_view start = text.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF") {
    const bool four = text.substr(2, 2) == std::string_view("\0\0", 2);
    return error_at(text, 0,
                    four ? "This file is UTF-32 text; save it as UTF-8."
                         : "This file is UTF-16 text; save it as UTF-8.");
  }
  bool halves = text.size() >= 2 && text[0] != text[1];
  for (std::size_t i = 0; halves && i + 1 < std::min(text.size(), looked_at); i += 2)
    halves = (text[i] == 0) != (text[i + 1] == 0) && (text[i] == 0) == (text[0] == 0);
  if (!halves) return std::nullopt;
  return error_at(text, 0, "This file is UTF-16 text; save it as UTF-8.");
}

}  // namespace lpq

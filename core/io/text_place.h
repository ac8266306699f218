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
  error.where.line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
  return error;
}

/// The refusal of text that has two bytes a character, as some editors on Windows save it: told by
/// its byte order mark, or by a first character that is half a zero.
inline std::optional<Error> refuse_utf16(std::string_view text) {
  const std::string_view start = text.substr(0, 2);
  const bool has_mark = start == "\xFF\xFE" || start == "\xFE\xFF";
  const bool half_zero = start.size() == 2 && (start[0] == 0) != (start[1] == 0);
  if (!has_mark && !half_zero) return std::nullopt;
  return error_at(text, 0, "This file is UTF-16 text; save it as UTF-8.");
}

}  // namespace lpq

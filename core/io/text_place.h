// Places in a text, for errors.
#pragma once

#include <algorithm>
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

}  // namespace lpq

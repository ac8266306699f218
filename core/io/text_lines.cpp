// See text_lines.h.
#include "io/text_lines.h"

#include <utility>

#include "io/plain_text.h"

namespace lpq {

LineReader::LineReader(std::string_view text) : text_(text) {
  next_ = start_ = byte_order_mark_size(text_);
  // Where no line ends with LF, as in files of old Macs, they end with CR.
  if (text_.find('\n') == std::string_view::npos) line_end_ = '\r';
}

std::string_view LineReader::next() {
  start_ = next_;
  ++line_;
  const std::size_t end = text_.find(line_end_, start_);
  next_ = end == std::string_view::npos ? text_.size() : end + 1;
  std::string_view line =
      text_.substr(start_, (end == std::string_view::npos ? next_ : end) - start_);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view LineReader::next_bytes(std::size_t count) {
  start_ = next_;
  next_ += count;
  return text_.substr(start_, count);
}

Error LineReader::error(std::string message) const {
  Error error{ErrorCode::parse_error, std::move(message), {}};
  error.where.set_line(line_, static_cast<std::int64_t>(start_));
  return error;
}

void Words::split(std::string_view line, bool has_comments) {
  words_.clear();
  constexpr std::string_view blanks = " \t\v\f\r";
  std::size_t i = line.find_first_not_of(blanks);
  while (i != std::string_view::npos && !(has_comments && line[i] == '#')) {
    const std::size_t end = line.find_first_of(blanks, i);
    words_.push_back(line.substr(i, end - i));
    i = line.find_first_not_of(blanks, end);
  }
}

}  // namespace lpq

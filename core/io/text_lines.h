// Lines of a text file, and the words of a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace lpq {

/// Lines of a text, without their line ends (LF, CRLF or CR) and a leading byte order mark.
class LineReader {
 public:
  explicit LineReader(std::string_view text);

  bool at_end() const { return next_ >= text_.size(); }
  /// The next line; empty at the end of the text.
  std::string_view next();
  /// The next bytes as they are, whose number is not greater than that of those left; next() then
  /// goes on behind them, and its lines are counted as if there were no line in them.
  std::string_view next_bytes(std::size_t count);
  std::size_t bytes_left() const { return text_.size() - next_; }
  /// Of the line read last: its number from 1, and its first byte.
  std::int64_t line() const { return line_; }
  std::int64_t byte() const { return static_cast<std::int64_t>(start_); }
  /// A parse_error at the line read last.
  Error error(std::string message) const;

 private:
  std::string_view text_;
  std::size_t start_ = 0, next_ = 0;
  std::int64_t line_ = 0;
  char line_end_ = '\n';
};

/// The words of a line, separated by blanks; with comments, a word that starts with '#' ends it.
class Words {
 public:
  void split(std::string_view line, bool has_comments = true);
  std::size_t size() const { return words_.size(); }
  std::string_view operator[](std::size_t i) const { return words_[i]; }

 private:
  std::vector<std::string_view> words_;
};

}  // namespace lpq

// The sections and rows of a .msh file, as lines of words or as binary numbers: what its parser
// reads, so that the grammar stands there once. In a binary file the names of sections, the
// physical names and the counts of version 2 are lines all the same.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/byte_order.h"
#include "io/text_lines.h"

namespace lpq {

class MshRows {
 public:
  explicit MshRows(std::string_view bytes) : lines_(bytes) {}

  /// The first failure stays: whatever is read after it is nothing, so that loops look at it alone.
  void fail(std::string message);
  bool failed() const { return failed_; }
  const Error& error() const { return error_; }
  /// Of the row read last: its line (none in a binary file) and first byte.
  std::int64_t line() const { return binary_ ? none : lines_.line(); }
  std::int64_t byte() const { return lines_.byte(); }

  /// To the next line "$Name", whose Name is then section(); false at the end and on failure.
  bool next_section();
  const std::string& section() const { return section_; }
  /// Reads "$EndName".
  void end_section();
  /// Passes over everything up to and with "$EndName".
  void skip_section();

  /// The next line; empty on failure.
  std::string_view next_line();
  /// The next line as at least `count` integers.
  bool read_line_of_integers(std::size_t count);

  /// The rows that follow are numbers in bytes. Reads the 1 that tells their order; a count has 4
  /// or 8 bytes, an int 4, a real 8.
  void begin_binary(int count_bytes);
  bool is_binary() const { return binary_; }

  /// A row of `ints`, then `counts`: of text, a line with at least as many integers.
  bool read_integers(std::size_t ints, std::size_t counts);
  const std::vector<std::int64_t>& integers() const { return integers_; }

  /// A row of mixed numbers, one after the other; a row of text is a line, whose rest is ignored.
  /// False where it has none, or no finite one; no failure by itself but at the end of the bytes.
  void begin_row();
  bool has_words(std::size_t count) const { return binary_ || words_.size() >= count; }
  bool read_int(std::int64_t& value);
  bool read_count(std::int64_t& value);
  bool read_real(double& value);
  void skip_ints(std::int64_t count);
  void skip_reals(std::int64_t count);

 private:
  std::string_view take(std::uint64_t count, std::uint64_t width);
  void skip(std::int64_t count, std::uint64_t width);
  bool read_word(std::int64_t& value);
  std::int64_t int_at(std::string_view bytes, std::size_t at) const;
  std::int64_t count_at(std::string_view bytes, std::size_t at);
  void fail_cut_off();

  LineReader lines_;
  Words words_;
  std::size_t word_ = 0;  // the next of the row
  std::vector<std::int64_t> integers_;
  std::string section_;  // that is being read
  bool binary_ = false;
  ByteOrder order_ = ByteOrder::little;
  std::uint64_t count_bytes_ = 8;
  bool failed_ = false;
  Error error_;
};

}  // namespace lpq

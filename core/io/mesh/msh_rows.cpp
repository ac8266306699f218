// See msh_rows.h.
#include "io/mesh/msh_rows.h"

#include <cmath>
#include <utility>

#include "io/number.h"

namespace lpq {
namespace {

constexpr std::uint64_t int_bytes = 4, real_bytes = 8;

}  // namespace

/// In the last line of a file that ends within a section, what is wrong is the end.
void MshRows::fail(std::string message) {
  if (failed_) return;
  failed_ = true;
  if (!binary_ && !section_.empty() && lines_.at_end())
    message +=
        " It is the last line, and '$End" + section_ + "' does not follow: the file was cut off.";
  error_ = lines_.error(std::move(message));
  error_.where.line = line();
}

void MshRows::fail_cut_off() {
  const std::string section = std::exchange(section_, {});
  fail("The file ends inside its section $" + section + ", before '$End" + section +
       "': it was cut off.");
}

bool MshRows::next_section() {
  while (!lines_.at_end() && !failed_) {
    words_.split(lines_.next());
    if (words_.size() == 0) continue;
    if (words_[0][0] != '$' || words_[0].substr(0, 4) == "$End") {
      fail("A section '$...' was expected.");
      return false;
    }
    section_ = words_[0].substr(1);
    return true;
  }
  return false;
}

void MshRows::end_section() {
  if (failed_) return;
  words_.split(next_line());
  while (binary_ && words_.size() == 0 && !failed_) words_.split(next_line());
  const bool ended = words_.size() == 1 && words_[0] == "$End" + section_;
  const std::string expected = "'$End" + section_ + "' was expected.";
  section_.clear();
  if (!ended) fail(expected);
}

void MshRows::skip_section() {
  const std::string end = "$End" + section_;
  while (!failed_) {
    words_.split(next_line());
    if (words_.size() != 1 || words_[0] != end) continue;
    section_.clear();
    return;
  }
}

std::string_view MshRows::next_line() {
  if (!failed_ && !lines_.at_end()) return lines_.next();
  fail_cut_off();
  return {};
}

bool MshRows::read_line_of_integers(std::size_t count) {
  words_.split(next_line());
  integers_.clear();
  for (std::size_t i = 0; i < words_.size() && !failed_; ++i) {
    std::int64_t value = 0;
    if (!parse_integer(words_[i], value))
      fail(std::string("'").append(words_[i].substr(0, 40)) + "' is not an integer.");
    integers_.push_back(value);
  }
  if (!failed_ && integers_.size() < count) fail("The line has too few numbers.");
  return !failed_;
}

/// What lacks the 1 is mostly text, so that the error is in its line.
void MshRows::begin_binary(int count_bytes) {
  Error wrong = lines_.error(
      "Behind this line of a binary .msh file there must be the number 1 in four bytes.");
  binary_ = true;
  count_bytes_ = static_cast<std::uint64_t>(count_bytes);
  const std::string_view one = take(1, int_bytes);
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    order_ = order;
    if (!failed_ && int_at(one, 0) == 1) return;
  }
  failed_ = true;
  error_ = std::move(wrong);
}

/// `count` numbers of `width` bytes; none, and a failure, where the file ends before. Counts in
/// the file may be any: they are compared before anything is made of them.
std::string_view MshRows::take(std::uint64_t count, std::uint64_t width) {
  if (failed_ || count == 0) return {};
  if (count <= lines_.bytes_left() / width)
    return lines_.next_bytes(static_cast<std::size_t>(count * width));
  fail_cut_off();
  return {};
}

std::int64_t MshRows::int_at(std::string_view bytes, std::size_t at) const {
  return static_cast<std::int32_t>(unsigned_at<std::uint32_t>(bytes, at, order_));
}

std::int64_t MshRows::count_at(std::string_view bytes, std::size_t at) {
  if (count_bytes_ == 4) return unsigned_at<std::uint32_t>(bytes, at, order_);
  const auto value = static_cast<std::int64_t>(unsigned_at<std::uint64_t>(bytes, at, order_));
  if (value < 0) fail("A count or a tag is out of range.");
  return value;
}

bool MshRows::read_integers(std::size_t ints, std::size_t counts) {
  if (!binary_) return read_line_of_integers(ints + counts);
  integers_.clear();
  const std::string_view first = take(ints, int_bytes);
  for (std::size_t i = 0; i < ints && !failed_; ++i)
    integers_.push_back(int_at(first, int_bytes * i));
  const std::string_view rest = take(counts, count_bytes_);
  for (std::size_t i = 0; i < counts && !failed_; ++i)
    integers_.push_back(count_at(rest, count_bytes_ * i));
  return !failed_;
}

void MshRows::begin_row() {
  word_ = 0;
  if (!binary_) words_.split(next_line());
}

bool MshRows::read_word(std::int64_t& value) {
  return word_ < words_.size() && parse_integer(words_[word_++], value);
}

bool MshRows::read_int(std::int64_t& value) {
  if (!binary_) return read_word(value);
  const std::string_view bytes = take(1, int_bytes);
  if (!failed_) value = int_at(bytes, 0);
  return !failed_;
}

bool MshRows::read_count(std::int64_t& value) {
  if (!binary_) return read_word(value);
  const std::string_view bytes = take(1, count_bytes_);
  if (!failed_) value = count_at(bytes, 0);
  return !failed_;
}

bool MshRows::read_real(double& value) {
  if (!binary_) return word_ < words_.size() && parse_number(words_[word_++], value);
  const std::string_view bytes = take(1, real_bytes);
  if (!failed_) value = float64_at(bytes, 0, order_);
  return !failed_ && std::isfinite(value);
}

void MshRows::skip(std::int64_t count, std::uint64_t width) {
  if (count <= 0) return;
  if (binary_) {
    take(static_cast<std::uint64_t>(count), width);
  } else {
    word_ += static_cast<std::size_t>(count);
  }
}

void MshRows::skip_ints(std::int64_t count) { skip(count, int_bytes); }

void MshRows::skip_reals(std::int64_t count) { skip(count, real_bytes); }

}  // namespace lpq

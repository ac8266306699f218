// See obj_text.h.
#include "io/obj_text.h"

#include <limits>

#include "io/number.h"
#include "io/surface/surface_text.h"

namespace lpq {
namespace {

constexpr std::string_view blanks = " \t\v\f\r";

bool begins_name(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  return word == "o" || word == "g" || word == "usemtl";
}

bool has_comment(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (at == 0 || blanks.find(line[at - 1]) != std::string_view::npos) return true;
  return false;
}

/// Whether the line goes on in the next one; if so, its backslash is dropped.
bool goes_on(std::string_view& line, bool is_name) {
  const std::size_t last = line.find_last_not_of(blanks);
  if (last == std::string_view::npos || line[last] != '\\') return false;
  if (!is_name && has_comment(line)) return false;
  line = line.substr(0, last);
  return true;
}

}  // namespace

const Words& ObjLines::next() {
  std::string_view line = lines_.next();
  first_ = lines_.error({});
  const bool is_name = begins_name(line);
  if (goes_on(line, is_name)) {
    joined_.clear();
    do {
      joined_ += line;
      joined_ += ' ';
      line = lines_.next();
    } while (goes_on(line, is_name));
    joined_ += line;
    line = joined_;
  }
  words_.split(line, !is_name);
  return words_;
}

Error ObjLines::error(std::string message) const {
  Error error = first_;
  error.message = std::move(message);
  return error;
}

Index ObjCorners::read(std::string_view word, Index count) {
  std::int64_t number = 0;
  if (!parse_integer(word.substr(0, word.find('/')), number)) {
    error_ = lines_.error("A face corner must be a vertex number.");
    return none;
  }
  // 0 is nobody's number.
  const std::int64_t vertex = number > 0 ? number - 1 : number < 0 ? count + number : -1;
  if (vertex < 0 || vertex >= std::numeric_limits<Index>::max()) {
    error_ = lines_.error(unknown_vertex(number, count, 1).message);
    return none;
  }
  const auto index = static_cast<Index>(vertex);
  if (index >= count && index > farthest_) {
    farthest_ = index;
    at_farthest_ = lines_.error({});
  }
  return index;
}

bool ObjCorners::all_there(Index count) {
  if (farthest_ < count) return true;
  error_ = at_farthest_;
  error_.message = unknown_vertex(std::int64_t{farthest_} + 1, count, 1).message;
  return false;
}

}  // namespace lpq

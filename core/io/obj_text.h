// What the readers of Wavefront OBJ share: lines that go on in the next ones, and corners of faces.
#pragma once

#include <string>
#include <string_view>

#include "io/text_lines.h"

namespace lpq {

/// Lines with those that they go on in after a backslash, blanks behind it or not. A comment never
/// goes on: paths in it may end in a backslash.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : lines_(text), first_(lines_.error({})) {}

  bool at_end() const { return lines_.at_end(); }
  /// The words of the next line. Names (o, g, usemtl) are all that follows: a '#' in them begins
  /// no comment.
  const Words& next();
  /// A parse_error at the first of the lines read last.
  Error error(std::string message) const;

 private:
  LineReader lines_;
  Words words_;
  std::string joined_;
  Error first_;
};

/// Numbers of vertices: from 1 on, of which some may come later, or back from the last one.
class ObjCorners {
 public:
  explicit ObjCorners(const ObjLines& lines) : lines_(lines) {}

  /// The vertex, from 0 on, of a corner such as 3, -1 or 3/1/2, with `count` vertices so far. none
  /// where it can be none, with the error.
  Index read(std::string_view word, Index count);
  /// After the last line: whether the vertices that were to come are among the `count`; if not,
  /// with the error.
  bool all_there(Index count);
  const Error& error() const { return error_; }

 private:
  const ObjLines& lines_;
  Index farthest_ = none;  // of the vertices that had not come
  Error at_farthest_, error_;
};

}  // namespace lpq

// Result<T>: a value, or an Error that speaks to a person. Member names follow std::expected.
// Three kinds of failure are kept apart: bad input is an Error; a method that did not reach its
// goal reports a status beside its best value; a bug trips LPQ_ASSERT.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/check.h"
#include "base/index.h"

namespace lpq {

enum class ErrorCode {
  // the input, judged once at the door
  parse_error,               // a file is not what it says it is
  bad_option,                // an option has no such name or is out of range
  non_finite,                // a coordinate or size is NaN or infinite
  empty,                     // no loop at all
  too_few_points,            // a loop with fewer than three distinct points
  duplicate_point,           // two equal consecutive points (strict mode), or two equal points
  zero_area,                 // a loop that encloses nothing
  self_intersection,         // two boundary edges cross
  overlapping_edges,         // two boundary edges share a piece of line (also spikes)
  touching,                  // two boundary edges touch in a single point, or all but
  hole_outside,              // a hole not inside the outer loop
  nested_or_duplicate_hole,  // a hole inside, or equal to, another hole
  region_conflict,           // two regions overlap
  bad_size,                  // a mesh size that is not positive, or larger than the domain
  odd_boundary,              // all quads asked for, but 4 Q = 2 E_int + B needs an even B
  too_narrow,                // a warning: a long gap whose walls get longer edges
  lost_precision,            // coordinates too coarse (far from the origin) for this mesh size
  too_many_elements,         // refused before allocating
  too_large,                 // a file or count beyond the stated limits
  ignored,                   // a warning: something given was left out or has no effect
  adapted,                   // a warning: something given was changed or read as something else
  // not the input's fault
  no_valid_mesh,  // no mesh that passes the final check was found
  out_of_memory,  // the machine, or WebAssembly's 4 GB, has no more
  cancelled,      // the caller ended the run
  io_error,       // a file cannot be read or written
};

/// Stable upper-case name, the same in C++, JSON, CLI and JavaScript: "SELF_INTERSECTION".
const char* code_name(ErrorCode code);

/// Where in the input: `none` and has_point = false mean "does not apply".
struct Where {
  Index region = none;      // index of the region as given
  Index loop = none;        // index of the loop as given, within its region
  Index edge = none;        // edge i runs from point i to point i+1 of that loop
  Index other_loop = none;  // the second edge of a crossing, touch or overlap
  Index other_edge = none;
  Index guide = none;  // index of the guide as given; `edge` is then one of its points
  bool has_point = false;
  double x = 0, y = 0;                    // coordinates in the caller's units
  std::int64_t line = none, byte = none;  // of a file, 1-based line, 0-based byte

  void set_point(double to_x, double to_y) {
    has_point = true;
    x = to_x;
    y = to_y;
  }
  void set_line(std::int64_t to_line, std::int64_t to_byte) {
    line = to_line;
    byte = to_byte;
  }
};

struct Error {
  ErrorCode code = ErrorCode::parse_error;
  std::string message;  // a sentence: what is wrong, where, what to do
  Where where;
};

/// What a check returns that makes no value: an Error if there is one.
using Problem = std::optional<Error>;

/// A repair or a shortfall that did not stop the work; listed in the report.
using Warning = Error;

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  T& value() & { return access(); }
  const T& value() const& { return const_cast<Result*>(this)->access(); }
  T&& value() && { return std::move(access()); }
  T& operator*() & { return access(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(access()); }
  T* operator->() { return &access(); }
  const T* operator->() const { return &value(); }
  const Error& error() const {
    LPQ_ASSERT(!has_value());
    return *std::get_if<1>(&state_);
  }

 private:
  T& access() {
    LPQ_ASSERT(has_value());
    return *std::get_if<0>(&state_);
  }
  std::variant<T, Error> state_;
};

}  // namespace lpq

// Writes JSON piece by piece into a string: commas, quotes and numbers are taken care of. NaN and
// infinities, which JSON does not have, become null.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/escape.h"
#include "io/number.h"

namespace lpq {

class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}

  void begin_object() { open('{'); }
  void end_object() { close('}'); }
  void begin_array() { open('['); }
  void end_array() { close(']'); }
  /// As a member: ends with end_object() and end_array() too.
  void begin_object(std::string_view name) {
    key(name);
    begin_object();
  }
  void begin_array(std::string_view name) {
    key(name);
    begin_array();
  }

  /// A member's name; its value comes next.
  void key(std::string_view name) {
    separate();
    append_json_string(out_, name);
    out_ += ':';
    first_ = true;
  }
  void value(std::string_view text) {
    separate();
    append_json_string(out_, text);
  }
  void value(const char* text) { value(std::string_view(text)); }
  void value(const std::string& text) { value(std::string_view(text)); }
  void value(bool flag) { raw(flag ? "true" : "false"); }
  void value(double number) {
    if (!std::isfinite(number)) return raw("null");
    separate();
    // "-0" is an integer to most readers, and loses its sign.
    if (number == 0 && std::signbit(number)) {
      out_ += "-0.0";
    } else {
      append_number(out_, number);
    }
  }
  template <class Integer>
  requires(std::is_integral_v<Integer> &&
           !std::is_same_v<Integer, bool>) void value(Integer number) {
    separate();
    append_integer(out_, static_cast<std::int64_t>(number));
  }
  void null() { raw("null"); }
  /// A line break, for readers with eyes.
  void new_line() {
    if (!first_) {
      out_ += ',';
      first_ = true;
    }
    out_ += '\n';
  }

  template <class T>
  void member(std::string_view name, const T& v) {
    key(name);
    value(v);
  }
  /// A short array such as a point or a face.
  template <class... Values>
  void tuple(Values... values) {
    begin_array();
    (..., value(values));
    end_array();
  }
  template <class Range>
  void array(std::string_view name, const Range& values) {
    begin_array(name);
    for (const auto& v : values) value(v);
    end_array();
  }

 private:
  void open(char bracket) {
    separate();
    out_ += bracket;
    first_ = true;
  }
  void close(char bracket) {
    out_ += bracket;
    first_ = false;
  }
  void raw(std::string_view text) {
    separate();
    out_ += text;
  }
  /// A comma before every value but the first one after a bracket or a key.
  void separate() {
    if (!first_) out_ += ',';
    first_ = false;
  }

  std::string& out_;
  bool first_ = true;
};

}  // namespace lpq

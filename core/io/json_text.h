// JSON text for readers that are pushed (SAX over nlohmann-json): how far the reading has come, and
// the bare NaN and Infinity that some programs write. For .cpp files only.
#pragma once

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"

namespace lpq {

inline constexpr std::size_t json_max_text = std::size_t{1} << 30;  // bytes
inline constexpr std::size_t json_max_depth = 64;                   // a domain needs 7, GeoJSON 10
inline constexpr int json_number_overflow = 406;  // nlohmann's identifier of the message

/// A reader that is pushed, to which all numbers are doubles.
class JsonReader : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// Only integers with a minus sign come here, so that zero was written -0, and keeps its sign.
  bool number_integer(number_integer_t value) final {
    return number(value == 0 ? -0.0 : static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) final { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) final { return number(value); }

 protected:
  virtual bool number(double value) = 0;
};

class JsonText {
 public:
  /// The text must stay where it is.
  explicit JsonText(std::string_view text);
  JsonText(const JsonText&) = delete;
  JsonText& operator=(const JsonText&) = delete;

  bool parse(JsonReader& reader);
  bool is_blank() const { return json_.find_first_not_of(" \t\r\n") == std::string::npos; }
  /// The reading has come to the last byte.
  bool at_end() const { return reached_ == json_.data() + json_.size(); }
  /// The empty string read last stands for NaN or Infinity.
  bool is_bare_literal() const;
  /// The byte read last.
  std::ptrdiff_t byte() const;
  /// An error at a byte, with its line. Cost: the bytes before it.
  Error error(ErrorCode code, std::string message, std::ptrdiff_t byte) const;
  Error error(ErrorCode code, std::string message) const {
    return error(code, std::move(message), byte());
  }

 private:
  /// An input iterator that shows how far the lexer has read.
  struct Cursor {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    const char** reached;

    reference operator*() const { return *at; }
    Cursor& operator++() {
      *reached = ++at;
      return *this;
    }
    Cursor operator++(int) {
      Cursor old = *this;
      ++*this;
      return old;
    }
    bool operator==(const Cursor& other) const { return at == other.at; }
    bool operator!=(const Cursor& other) const { return at != other.at; }
  };

  std::string_view text_;
  std::string json_;  // of the same width as the text, without NaN and Infinity
  const char* reached_;
};

}  // namespace lpq

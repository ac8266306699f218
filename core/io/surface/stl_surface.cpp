// See stl_surface.h.
#include "io/surface/stl_surface.h"

#include <array>

#include "io/byte_order.h"
#include "io/plain_text.h"
#include "io/surface/soup_builder.h"
#include "io/surface/surface_text.h"
#include "io/text_place.h"

namespace lpq {
namespace {

constexpr std::size_t header_size = 80, facet_size = 50;

std::uint64_t facets_claimed(std::string_view bytes) {
  return unsigned_at<std::uint32_t>(bytes, header_size, ByteOrder::little);
}

Error error_at_byte(ErrorCode code, std::size_t byte, std::string message) {
  Error error{code, std::move(message), {}};
  error.where.byte = static_cast<std::int64_t>(byte);
  return error;
}

Result<SurfaceSoup> read_binary(std::string_view bytes) {
  constexpr std::size_t first = header_size + 4;
  if (bytes.size() < first)
    return error_at_byte(ErrorCode::parse_error, bytes.size(),
                         "This is no STL file: it does not begin with 'solid', and a binary one "
                         "has 84 bytes or more.");
  const std::uint64_t count = facets_claimed(bytes), present = (bytes.size() - first) / facet_size;
  if (count > present)
    return error_at_byte(ErrorCode::parse_error, bytes.size(),
                         "The file ends after " + std::to_string(present) + " of " +
                             std::to_string(count) + " facets.");
  SoupBuilder builder;
  for (std::uint64_t f = 0; f < count; ++f) {
    const Index v = builder.point_count();
    for (std::size_t k = 0; k < 3; ++k) {
      // A facet is its normal, three points and two bytes of attributes.
      const std::size_t at = first + static_cast<std::size_t>(f) * facet_size + 12 * (k + 1);
      const Vec3 p{float32_at(bytes, at, ByteOrder::little),
                   float32_at(bytes, at + 4, ByteOrder::little),
                   float32_at(bytes, at + 8, ByteOrder::little)};
      if (!is_finite(p))
        return error_at_byte(
            ErrorCode::non_finite, at,
            "Facet " + std::to_string(f) + " has a coordinate that is not finite.");
      builder.add_point(p);
    }
    builder.add_polygon(std::array<Index, 3>{v, v + 1, v + 2});
    if (builder.too_large()) return too_many_triangles();
  }
  if (count == 0 && present > 0)
    return error_at_byte(ErrorCode::parse_error, header_size,
                         "The file says that it has 0 facets, but is as long as one with " +
                             std::to_string(present) + ". Write it anew.");
  if (count == 0) return Error{ErrorCode::empty, "The file has no facet.", {}};
  return builder.take();
}

/// Words as they come: some programs put a whole facet on one line.
class StlTextReader {
 public:
  explicit StlTextReader(std::string_view text) : text_(text) {}

  Result<SurfaceSoup> read() {
    while (!failed_ && next_word()) read_word();
    if (!failed_ && in_facet_) fail("The file ends inside a facet.");
    if (failed_) return error_;
    if (builder_.too_large()) return too_many_triangles();
    if (!builder_.has_polygon()) return Error{ErrorCode::empty, "The file has no facet.", {}};
    return builder_.take();
  }

 private:
  static constexpr std::string_view blanks = " \t\v\f\r\n";

  void fail(std::string message, ErrorCode code = ErrorCode::parse_error) {
    if (failed_) return;
    failed_ = true;
    if (next_ >= text_.size() && start_ < text_.size())
      message += " It is the last word: the file may have been cut off.";
    error_ = error_at(text_, start_, std::move(message), code);
  }

  bool next_word() {
    start_ = std::min(text_.find_first_not_of(blanks, next_), text_.size());
    next_ = std::min(text_.find_first_of(blanks, start_), text_.size());
    word_ = text_.substr(start_, next_ - start_);
    return !word_.empty();
  }

  void read_word() {
    if (same_letters(word_, "solid")) {
      start_solid();
    } else if (same_letters(word_, "endsolid")) {
      rest_of_line();
    } else if (same_letters(word_, "facet")) {
      start_facet();
    } else if (same_letters(word_, "vertex")) {
      read_vertex();
    } else if (same_letters(word_, "endfacet")) {
      end_facet();
    } else if (same_letters(word_, "color")) {
      rest_of_line();
    } else if (!same_letters(word_, "outer") && !same_letters(word_, "loop") &&
               !same_letters(word_, "endloop")) {
      std::string message = "'";
      message += word_.substr(0, 40);
      fail(message + "' is not a word of an STL file.");
    }
  }

  std::string_view rest_of_line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
    const std::string_view rest = text_.substr(next_, end - next_);
    next_ = end;
    return rest;
  }

  void start_solid() {
    if (in_facet_) return fail("A solid begins inside a facet.");
    Words words;
    words.split(rest_of_line(), false);
    builder_.set_group(std::to_string(++solids_), joined_words(words, 0));
  }

  void start_facet() {
    if (in_facet_) return fail("A facet begins inside a facet.");
    in_facet_ = true;
    corners_.clear();
    // The normal is not needed and is often wrong.
    const std::size_t after = next_;
    if (!next_word() || !same_letters(word_, "normal")) {
      next_ = after;
      return;
    }
    for (int k = 0; k < 3; ++k) next_word();
  }

  void read_vertex() {
    if (!in_facet_) return fail("A vertex stands outside of a facet.");
    Vec3 p;
    for (double* const x : {&p.x, &p.y, &p.z}) {
      next_word();
      if (parse_number(word_, *x)) continue;
      return is_not_finite_word(word_)
                 ? fail("A vertex has a coordinate that is not finite.", ErrorCode::non_finite)
                 : fail("A vertex needs three finite numbers: x y z." + advice_on_comma(word_));
    }
    corners_.push_back(builder_.point_count());
    builder_.add_point(p);
  }

  void end_facet() {
    if (!in_facet_ || corners_.size() < 3) return fail("A facet needs three vertices.");
    in_facet_ = false;
    builder_.add_polygon(corners_);
  }

  std::string_view text_, word_;
  std::size_t start_ = 0, next_ = 0;  // of the word
  SoupBuilder builder_;
  std::vector<Index> corners_;
  int solids_ = 0;
  bool in_facet_ = false, failed_ = false;
  Error error_;
};

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t first = header_size + 4;
  return bytes.size() >= first && facets_claimed(bytes) * facet_size == bytes.size() - first;
}

Result<SurfaceSoup> read_stl_surface(std::string_view bytes) {
  // Some binary files begin with 'solid', too; no text holds a zero.
  if (is_binary_stl(bytes) || bytes.find('\0') != std::string_view::npos) return read_binary(bytes);
  const std::string_view text = bytes.substr(byte_order_mark_size(bytes));
  if (same_letters(past_blanks(text).substr(0, 5), "solid")) return StlTextReader(text).read();
  return read_binary(bytes);
}

}  // namespace lpq

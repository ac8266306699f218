// See ply_header.h.
#include "io/surface/ply_header.h"

#include <algorithm>
#include <array>

#include "io/number.h"
#include "io/plain_text.h"
#include "io/text_lines.h"
#include "io/text_place.h"

namespace lpq {
namespace {

bool type_by_name(std::string_view name, PlyType& type) {
  struct Name {
    std::string_view name;
    PlyType type;
  };
  constexpr std::array<Name, 16> names{{{"char", PlyType::int8},
                                        {"int8", PlyType::int8},
                                        {"uchar", PlyType::uint8},
                                        {"uint8", PlyType::uint8},
                                        {"short", PlyType::int16},
                                        {"int16", PlyType::int16},
                                        {"ushort", PlyType::uint16},
                                        {"uint16", PlyType::uint16},
                                        {"int", PlyType::int32},
                                        {"int32", PlyType::int32},
                                        {"uint", PlyType::uint32},
                                        {"uint32", PlyType::uint32},
                                        {"float", PlyType::float32},
                                        {"float32", PlyType::float32},
                                        {"double", PlyType::float64},
                                        {"float64", PlyType::float64}}};
  for (const Name& one : names) {
    if (one.name != name) continue;
    type = one.type;
    return true;
  }
  return false;
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : bytes_(bytes) {}

  Result<PlyHeader> read() {
    next_ = byte_order_mark_size(bytes_);
    if (next_line(); words_.size() != 1 || words_[0] != "ply")
      fail("A PLY file begins with 'ply'.");
    while (!failed_) {
      if (next_ >= bytes_.size()) {
        fail("The header has no 'end_header'.");
        break;
      }
      next_line();
      if (words_.size() == 0) continue;
      if (words_[0] == "end_header") break;
      read_line();
    }
    if (!failed_ && !has_format_) fail("The header has no 'format'.");
    if (failed_) return error_;
    header_.size = next_;
    return std::move(header_);
  }

 private:
  void fail(std::string message) {
    if (failed_) return;
    failed_ = true;
    error_ = error_at(bytes_, start_, std::move(message));
  }

  void next_line() {
    start_ = next_;
    const std::size_t end = std::min(bytes_.find_first_of("\r\n", start_), bytes_.size());
    words_.split(bytes_.substr(start_, end - start_));
    // Where a line before ended in CR alone, an LF behind it is the first of the data.
    const bool crlf = !only_cr_ && bytes_.substr(end, 2) == "\r\n";
    only_cr_ = only_cr_ || (!crlf && bytes_.substr(end, 1) == "\r");
    next_ = std::min(end + (crlf ? 2 : 1), bytes_.size());
  }

  void read_line() {
    if (words_[0] == "comment" || words_[0] == "obj_info") return;
    if (words_[0] == "format") return read_format();
    if (words_[0] == "element") return read_element();
    if (words_[0] == "property") return read_property();
    fail("A line of the header must be format, comment, element or property.");
  }

  void read_format() {
    has_format_ = true;
    const std::string_view name = words_.size() > 1 ? words_[1] : std::string_view();
    if (name == "ascii") {
      header_.format = PlyFormat::text;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      fail("The format must be ascii, binary_little_endian or binary_big_endian.");
    }
  }

  void read_element() {
    PlyElement element;
    if (words_.size() < 3 || !parse_integer(words_[2], element.count) || element.count < 0)
      return fail("An element needs a name and a count.");
    element.name = words_[1];
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    PlyProperty property;
    property.is_list = words_.size() > 1 && words_[1] == "list";
    const std::size_t at = property.is_list ? 3 : 1;
    if (header_.elements.empty() || words_.size() < at + 2 ||
        !type_by_name(words_[at], property.type) ||
        (property.is_list && !type_by_name(words_[2], property.count_type)))
      return fail("A property needs an element, a type and a name.");
    if (property.is_list && property.count_type >= PlyType::float32)
      return fail("The length of a list must be an integer.");
    property.name = words_[at + 1];
    header_.elements.back().properties.push_back(std::move(property));
  }

  std::string_view bytes_;
  std::size_t start_ = 0, next_ = 0;  // of the line
  Words words_;
  PlyHeader header_;
  bool only_cr_ = false, has_format_ = false, failed_ = false;
  Error error_;
};

}  // namespace

Index PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return static_cast<Index>(i);
  return none;
}

Result<PlyHeader> read_ply_header(std::string_view bytes) { return HeaderReader(bytes).read(); }

}  // namespace lpq

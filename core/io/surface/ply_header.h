// The head of a PLY file: what its elements are made of [Turk 1994].
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace lpq {

enum class PlyFormat { text, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Index of a property, none if there is no such one.
  Index find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  // bytes, with the line end of end_header
};

constexpr std::size_t bytes_of(PlyType type) {
  constexpr std::size_t bytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

/// Lines may end in LF, CRLF or CR; a byte order mark may come first. Errors: parse_error with line
/// and byte.
Result<PlyHeader> read_ply_header(std::string_view bytes);

}  // namespace lpq

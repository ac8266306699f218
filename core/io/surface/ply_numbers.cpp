// See ply_numbers.h.
#include "io/surface/ply_numbers.h"

#include <cmath>
#include <cstdint>

#include "io/byte_order.h"
#include "io/number.h"
#include "io/surface/surface_text.h"

namespace lpq {
namespace {

constexpr std::string_view blanks = " \t\v\f\r\n";

}  // namespace

double PlyNumbers::next_word() {
  start_ = std::min(bytes_.find_first_not_of(blanks, next_), bytes_.size());
  next_ = std::min(bytes_.find_first_of(blanks, start_), bytes_.size());
  const std::string_view word = bytes_.substr(start_, next_ - start_);
  double value = 0;
  if (parse_number(word, value)) return value;
  if (is_not_finite_word(word)) return std::nan("");
  failed_ = true;
  return 0;
}

double PlyNumbers::next_bytes(PlyType type) {
  start_ = next_;
  const std::size_t size = bytes_of(type);
  if (bytes_.size() - next_ < size) {
    failed_ = true;
    next_ = bytes_.size();
    return 0;
  }
  next_ += size;
  const ByteOrder order = format_ == PlyFormat::big_endian ? ByteOrder::big : ByteOrder::little;
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(unsigned_at<std::uint8_t>(bytes_, start_, order));
    case PlyType::uint8: return unsigned_at<std::uint8_t>(bytes_, start_, order);
    case PlyType::int16:
      return static_cast<std::int16_t>(unsigned_at<std::uint16_t>(bytes_, start_, order));
    case PlyType::uint16: return unsigned_at<std::uint16_t>(bytes_, start_, order);
    case PlyType::int32:
      return static_cast<std::int32_t>(unsigned_at<std::uint32_t>(bytes_, start_, order));
    case PlyType::uint32: return unsigned_at<std::uint32_t>(bytes_, start_, order);
    case PlyType::float32: return float32_at(bytes_, start_, order);
    case PlyType::float64: return float64_at(bytes_, start_, order);
  }
  return 0;
}

}  // namespace lpq

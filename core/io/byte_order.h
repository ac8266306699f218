// Numbers from bytes, in either order, on any machine.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace lpq {

enum class ByteOrder { little, big };

/// An unsigned number of sizeof(T) bytes at `at`, which must be there.
template <class T>
T unsigned_at(std::string_view bytes, std::size_t at, ByteOrder order) {
  T value = 0;
  for (std::size_t k = 0; k < sizeof(T); ++k) {
    const std::size_t place = order == ByteOrder::little ? sizeof(T) - 1 - k : k;
    value =
        static_cast<T>((std::uint64_t{value} << 8) | static_cast<unsigned char>(bytes[at + place]));
  }
  return value;
}

/// A float or double as IEEE 754 writes it.
template <class Float, class Bits>
double float_at(std::string_view bytes, std::size_t at, ByteOrder order) {
  static_assert(sizeof(Float) == sizeof(Bits));
  const Bits bits = unsigned_at<Bits>(bytes, at, order);
  Float value;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}
inline double float32_at(std::string_view bytes, std::size_t at, ByteOrder order) {
  return float_at<float, std::uint32_t>(bytes, at, order);
}
inline double float64_at(std::string_view bytes, std::size_t at, ByteOrder order) {
  return float_at<double, std::uint64_t>(bytes, at, order);
}

}  // namespace lpq

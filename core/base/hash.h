// FNV-1a over the bytes of plain arrays: the fingerprint of a mesh in reports and determinism
// tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace lpq {

class Fnv1a {
 public:
  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size_bytes(); ++i)
      state_ = (state_ ^ bytes[i]) * 0x100000001B3u;
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325u;
};

}  // namespace lpq

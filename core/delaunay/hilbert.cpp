// Hilbert order by keys of 2 x 16 bits and a radix sort; points that share a cell (clusters) are
// ordered by a curve of their own. Cost O(n).
#include "delaunay/hilbert.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "delaunay/delaunay.h"
#include "geometry/box.h"

namespace lpq {
namespace {

// The key in the upper half, the point's index in the lower.
using Keyed = std::uint64_t;

std::uint32_t key_of(Keyed item) { return static_cast<std::uint32_t>(item >> 32); }
Index point_of(Keyed item) { return static_cast<Index>(item & 0xFFFFFFFFu); }

// Three passes of eleven bits, least significant first; stable.
void radix_sort(std::vector<Keyed>& items) {
  constexpr int digit_bits = 11;
  static_assert(3 * digit_bits >= 2 * hilbert_bits);
  std::vector<Keyed> other(items.size());
  for (int pass = 0; pass < 3; ++pass) {
    const int shift = 32 + pass * digit_bits;
    const auto digit = [&](Keyed item) {
      return static_cast<std::size_t>((item >> shift) & ((1u << digit_bits) - 1));
    };
    std::array<std::uint32_t, (1u << digit_bits) + 1> begin{};
    for (const Keyed item : items) ++begin[digit(item) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (const Keyed item : items) other[begin[digit(item)]++] = item;
    items.swap(other);
  }
}

// Orders the indices in `order` along the curve of their own bounding box.
void sort_along_curve(std::span<const Vec2> points, std::span<Index> order) {
  if (order.size() < 2) return;
  Box box = empty_box();
  for (const Index i : order) extend(box, points[i]);
  const double extent = longer_side(box);
  if (!(extent > 0)) return;
  constexpr double last = (1 << hilbert_bits) - 1;
  const double scale = last / extent;
  const auto cell = [&](double v) {
    return static_cast<std::uint32_t>(std::clamp(v * scale, 0.0, last));
  };
  std::vector<Keyed> keyed(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Vec2 p = points[order[k]] - box.lo;
    keyed[k] =
        Keyed{hilbert_position(cell(p.x), cell(p.y))} << 32 | static_cast<std::uint32_t>(order[k]);
  }
  radix_sort(keyed);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = point_of(keyed[k]);

  constexpr std::size_t cluster = 64;  // fewer in a cell do not lengthen the walks
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && key_of(keyed[end]) == key_of(keyed[begin])) ++end;
    if (end - begin >= cluster) sort_along_curve(points, order.subspan(begin, end - begin));
  }
}

// 0 is the last round with 7/8 of the points, 1 the one before with 7/64, and so on.
int round_of(std::uint32_t i) {
  std::uint32_t h = i * 0x9E3779B1u;
  h = (h ^ (h >> 15)) * 0x85EBCA77u;
  h = (h ^ (h >> 13)) * 0xC2B2AE3Du;
  h ^= h >> 16;
  int round = 0;
  for (; round < 7 && (h & 7u) == 0; ++round) h >>= 3;
  return round;
}

}  // namespace

std::uint32_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  // Without branches: the bits of scattered points are as good as random, hence unpredictable.
  std::uint32_t position = 0;
  for (int bit = hilbert_bits - 1; bit >= 0; --bit) {
    const std::uint32_t right = (x >> bit) & 1u, top = (y >> bit) & 1u;
    position = position << 2 | ((3u * right) ^ top);
    // The lower quadrants are traversed transposed, the right one of them also backwards.
    const std::uint32_t reflect = 0u - (right & ~top), transpose = top - 1u;
    const std::uint32_t exchange = (x ^ y) & transpose;
    x ^= exchange ^ reflect;
    y ^= exchange ^ reflect;
  }
  return position;
}

std::vector<Index> hilbert_order(std::span<const Vec2> points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  sort_along_curve(points, order);
  return order;
}

std::vector<Index> insertion_rounds(Index count) {
  std::array<Index, 8> size{}, next{};
  for (Index i = 0; i < count; ++i) ++size[round_of(static_cast<std::uint32_t>(i))];
  for (int round = 6; round >= 0; --round) next[round] = next[round + 1] + size[round + 1];
  std::vector<Index> order(count);
  for (Index i = 0; i < count; ++i) order[next[round_of(static_cast<std::uint32_t>(i))]++] = i;
  return order;
}

}  // namespace lpq

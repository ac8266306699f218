// Floating-point expansions [Shewchuk 1997]: a number as an exact sum of doubles that do not
// overlap, smallest first, zeros left out. Sums and products of expansions are exact as long as
// nothing overflows or underflows. Two rules of the house apply: products are split by Dekker's
// method, because a fused multiply-add is not the same operation on every platform, and capacities
// are compile-time bounds, so nothing is allocated.
#pragma once

#include <array>

#include "base/check.h"

namespace lpq::exact {

/// hi + lo is the exact result, hi its rounding.
struct Pair {
  double hi = 0, lo = 0;
};

inline Pair two_sum(double a, double b) {
  const double hi = a + b;
  const double b_part = hi - a;
  const double a_part = hi - b_part;
  return {hi, (a - a_part) + (b - b_part)};
}

inline Pair two_difference(double a, double b) { return two_sum(a, -b); }

/// two_sum for |a| >= |b|.
inline Pair fast_two_sum(double a, double b) {
  const double hi = a + b;
  return {hi, b - (hi - a)};
}

/// Halves of 26 bits each, so that products of halves are exact [Dekker 1971].
inline Pair split(double a) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double c = splitter * a;
  const double hi = c - (c - a);
  return {hi, a - hi};
}

inline Pair two_product(double a, double b) {
  const double hi = a * b;
  const Pair p = split(a), q = split(b);
  const double rest = ((hi - p.hi * q.hi) - p.lo * q.hi) - p.hi * q.lo;
  return {hi, p.lo * q.lo - rest};
}

/// At most `Capacity` components, by increasing magnitude; no component means zero.
template <int Capacity>
struct Expansion {
  std::array<double, Capacity> components;  // only the first `count` are set
  int count = 0;

  Expansion() = default;
  explicit Expansion(Pair p) requires(Capacity >= 2) {
    push(p.lo);
    push(p.hi);
  }

  void push(double value) {
    if (value == 0) return;
    LPQ_ASSERT(count < Capacity);
    components[count++] = value;
  }
  /// The largest component decides.
  int sign() const { return count == 0 ? 0 : (components[count - 1] > 0 ? 1 : -1); }
};

/// Merges by magnitude, then carries upwards (Shewchuk's FAST-EXPANSION-SUM).
template <int A, int B>
Expansion<A + B> operator+(const Expansion<A>& a, const Expansion<B>& b) {
  Expansion<A + B> sum;
  int i = 0, j = 0;
  const auto next = [&] {
    if (j == b.count) return a.components[i++];
    if (i == a.count) return b.components[j++];
    const double x = a.components[i], y = b.components[j];
    return (y > x) == (y > -x) ? (++i, x) : (++j, y);
  };
  if (a.count + b.count == 0) return sum;
  double carry = next();
  while (i < a.count || j < b.count) {
    const Pair s = two_sum(carry, next());
    sum.push(s.lo);
    carry = s.hi;
  }
  sum.push(carry);
  return sum;
}

template <int A>
Expansion<A> operator-(Expansion<A> a) {
  for (int i = 0; i < a.count; ++i) a.components[i] = -a.components[i];
  return a;
}

template <int A, int B>
Expansion<A + B> operator-(const Expansion<A>& a, const Expansion<B>& b) {
  return a + (-b);
}

/// SCALE-EXPANSION: every component times a double.
template <int A>
Expansion<2 * A> scaled(const Expansion<A>& a, double factor) {
  Expansion<2 * A> result;
  if (a.count == 0) return result;
  Pair carry = two_product(a.components[0], factor);
  result.push(carry.lo);
  for (int i = 1; i < a.count; ++i) {
    const Pair product = two_product(a.components[i], factor);
    const Pair low = two_sum(carry.hi, product.lo);
    result.push(low.lo);
    carry = fast_two_sum(product.hi, low.hi);
    result.push(carry.lo);
  }
  result.push(carry.hi);
  return result;
}

/// The sum of `a` scaled by every component of b.
template <int A, int B>
Expansion<2 * A * B> operator*(const Expansion<A>& a, const Expansion<B>& b) {
  Expansion<2 * A * B> result;
  for (int j = 0; j < b.count; ++j) {
    const auto next = result + scaled(a, b.components[j]);
    LPQ_ASSERT(next.count <= 2 * A * B);
    result.count = next.count;
    for (int i = 0; i < next.count; ++i) result.components[i] = next.components[i];
  }
  return result;
}

}  // namespace lpq::exact

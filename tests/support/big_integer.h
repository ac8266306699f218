// Signed integers of any size, just enough (+ - * and the sign) to be the oracle of the predicates:
// it shares no idea with floating-point expansions.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace lpq_test {

class BigInteger {
 public:
  BigInteger() = default;
  BigInteger(std::int64_t value) : negative_(value < 0) {
    std::uint64_t rest = negative_ ? 0 - static_cast<std::uint64_t>(value) : value;
    for (; rest != 0; rest >>= 32) limbs_.push_back(static_cast<std::uint32_t>(rest));
  }
  /// value * 2^scale, which must be an integer below 2^63 in magnitude.
  static BigInteger of(double value, int scale) {
    return BigInteger(static_cast<std::int64_t>(std::ldexp(value, scale)));
  }

  int sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }

  BigInteger operator-() const {
    BigInteger result = *this;
    result.negative_ = !negative_;
    return result;
  }
  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    if (a.negative_ == b.negative_) {
      result.limbs_ = add(a.limbs_, b.limbs_);
      result.negative_ = a.negative_;
    } else if (less(a.limbs_, b.limbs_)) {
      result.limbs_ = subtract(b.limbs_, a.limbs_);
      result.negative_ = b.negative_;
    } else {
      result.limbs_ = subtract(a.limbs_, b.limbs_);
      result.negative_ = a.negative_;
    }
    return result;
  }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + (-b); }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
    for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.limbs_.size() || carry != 0; ++j) {
        const std::uint64_t factor = j < b.limbs_.size() ? b.limbs_[j] : 0;
        const std::uint64_t sum = result.limbs_[i + j] + a.limbs_[i] * factor + carry;
        result.limbs_[i + j] = static_cast<std::uint32_t>(sum);
        carry = sum >> 32;
      }
    }
    trim(result.limbs_);
    result.negative_ = a.negative_ != b.negative_;
    return result;
  }

 private:
  using Limbs = std::vector<std::uint32_t>;  // least significant first, no leading zero

  static void trim(Limbs& limbs) {
    while (!limbs.empty() && limbs.back() == 0) limbs.pop_back();
  }
  static bool less(const Limbs& a, const Limbs& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    for (std::size_t i = a.size(); i-- > 0;) {
      if (a[i] != b[i]) return a[i] < b[i];
    }
    return false;
  }
  static Limbs add(const Limbs& a, const Limbs& b) {
    Limbs sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.size() || i < b.size() || carry != 0; ++i) {
      carry += (i < a.size() ? a[i] : 0ull) + (i < b.size() ? b[i] : 0ull);
      sum.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    return sum;
  }
  static Limbs subtract(const Limbs& a, const Limbs& b) {
    Limbs rest;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      borrow += static_cast<std::int64_t>(a[i]) - (i < b.size() ? b[i] : 0);
      rest.push_back(static_cast<std::uint32_t>(borrow));
      borrow >>= 32;
    }
    trim(rest);
    return rest;
  }

  Limbs limbs_;
  bool negative_ = false;
};

}  // namespace lpq_test

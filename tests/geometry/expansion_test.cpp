// Expansion arithmetic against big integers: sums and products are exact, whatever the
// cancellation.
#include "geometry/expansion.h"

#include "base/rng.h"
#include "catch.h"
#include "support/big_integer.h"

using lpq::Rng;
using lpq_test::BigInteger;
using namespace lpq::exact;

namespace {

// Integers below 2^53 of very different sizes, as doubles.
double integer(Rng& rng) {
  const auto bits = static_cast<int>(1 + rng.below(53));
  const double magnitude = static_cast<double>(rng.next() >> (64 - bits));
  return rng.below(2) == 0 ? magnitude : -magnitude;
}

Expansion<2> one(double value) { return Expansion<2>(Pair{value, 0}); }

BigInteger big(double value) { return BigInteger::of(value, 0); }

}  // namespace

TEST_CASE("error-free transformations are error free") {
  Rng rng(1);
  for (int i = 0; i < 100000; ++i) {
    const double a = integer(rng), b = integer(rng);
    const Pair sum = two_sum(a, b), product = two_product(a, b);
    CHECK((big(sum.hi) + big(sum.lo) - big(a) - big(b)).sign() == 0);
    CHECK(sum.hi == a + b);
    CHECK(product.hi == a * b);
    // hi can exceed 64 bits: a b - hi - lo = 0 is checked in pieces of 2^53.
    const double head = product.hi / 0x1p53;
    const double upper = std::trunc(head), lower = product.hi - upper * 0x1p53;
    const BigInteger hi = big(upper) * BigInteger(std::int64_t{1} << 53) + big(lower);
    CHECK((big(a) * big(b) - hi - big(product.lo)).sign() == 0);
  }
}

TEST_CASE("signs of sums of products agree with big integers") {
  Rng rng(2);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = integer(rng), b = integer(rng), c = integer(rng), d = integer(rng);
    const double e = i % 3 == 0 ? a : integer(rng), f = i % 3 == 0 ? b : integer(rng);
    // (a + b)(c + d) - (e + f)(c + d) + a: almost total cancellation in every third case.
    const auto value = (one(a) + one(b)) * (one(c) + one(d)) -
                       (one(e) + one(f)) * (one(c) + one(d)) + one(i % 6 == 0 ? 0.0 : a);
    const BigInteger truth = (big(a) + big(b)) * (big(c) + big(d)) -
                             (big(e) + big(f)) * (big(c) + big(d)) +
                             (i % 6 == 0 ? BigInteger() : big(a));
    CHECK(value.sign() == truth.sign());
    if (value.sign() == 0) {
      ++zeros;
      CHECK(value.count == 0);
    }
  }
  CHECK(zeros > 1000);
}

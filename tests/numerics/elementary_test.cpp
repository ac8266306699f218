// Our own elementary functions against the C library's, and their exact symmetries.
#include "numerics/elementary.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"

using namespace lpq;

TEST_CASE("elementary functions agree with the library to a few units in the last place") {
  Rng rng(7);
  for (int i = 0; i < 100000; ++i) {
    const double x = rng.between(-300, 300), y = rng.between(-300, 300);
    const SinCos s = sin_cos(x);
    CHECK_FALSE(std::abs(s.sin - std::sin(x)) > 3e-16);
    CHECK_FALSE(std::abs(s.cos - std::cos(x)) > 3e-16);
    CHECK_FALSE(std::abs(arc_tangent(y, x) - std::atan2(y, x)) > 1e-15);
    CHECK_FALSE(std::abs(exponential(x) / std::exp(x) - 1) > 1e-15);
    const double positive = std::exp(x);
    CHECK_FALSE(std::abs(logarithm(positive) - std::log(positive)) > 1e-13);
  }
}

TEST_CASE("special values are exact") {
  CHECK(sin_cos(0).sin == 0);
  CHECK(sin_cos(0).cos == 1);
  CHECK(arc_tangent(0, 0) == 0);
  CHECK(arc_tangent(0, 1) == 0);
  CHECK(arc_tangent(0, -1) == pi);
  CHECK(arc_tangent(1, 0) == pi / 2);
  CHECK(arc_tangent(-1, 0) == -pi / 2);
  CHECK(exponential(0) == 1);
  CHECK(logarithm(1) == 0);
  CHECK(logarithm(0x1p52) == 52 * logarithm(2));
}

TEST_CASE("the arc tangent does not depend on the length of its vector's power of two") {
  Rng rng(8);
  for (int i = 0; i < 1000; ++i) {
    const double x = rng.between(-1, 1), y = rng.between(-1, 1);
    CHECK(arc_tangent(y, x) == arc_tangent(0x1p30 * y, 0x1p30 * x));
    CHECK(arc_tangent(-y, x) == -arc_tangent(y, x));
  }
}

// Integer powers by multiplication: exact order of operations, same bits everywhere.
#pragma once

namespace lpq {

constexpr double integer_power(double x, int n) {
  double result = 1;
  for (double base = x; n > 0; n >>= 1, base *= base)
    if (n & 1) result *= base;
  return result;
}

}  // namespace lpq

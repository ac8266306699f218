#include "numerics/elementary.h"

#include <cmath>

namespace lpq {
namespace {

// pi/2 in three parts: the first two have enough trailing zeros that k * part is exact for
// |k| < 2^20 (Cody and Waite's reduction).
constexpr double half_pi_1 = 0x1.921fb544p+0;
constexpr double half_pi_2 = 0x1.0b4611a6p-34;
constexpr double half_pi_3 = 0x1.3198a2e037073p-69;

// Taylor series on |r| <= pi/4: the first dropped term is below 2^-60.
double sin_series(double r) {
  const double s = r * r;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = (1 + sum) * (-s * (1.0 / (k * (k - 1))));
  return r + r * sum;
}

double cos_series(double r) {
  const double s = r * r;
  double sum = 0;
  for (int k = 18; k >= 4; k -= 2) sum = (1 + sum) * (-s * (1.0 / (k * (k - 1))));
  return 1 - 0.5 * s * (1 + sum);
}

// atan for 0 <= x <= 1: two half-angle steps bring it below tan(pi/16), then the series in x.
double arc_tangent_unit(double x) {
  double t = x;
  for (int step = 0; step < 2; ++step) t = t / (1 + std::sqrt(1 + t * t));
  const double s = t * t;
  double sum = 0;
  for (int k = 25; k >= 3; k -= 2) sum = s * (1.0 / k - sum);
  return 4 * (t - t * sum);
}

}  // namespace

SinCos sin_cos(double x) {
  const double k = std::floor(x * (2 / pi) + 0.5);
  const double r = ((x - k * half_pi_1) - k * half_pi_2) - k * half_pi_3;
  const double s = sin_series(r), c = cos_series(r);
  const int quadrant = static_cast<int>(static_cast<long long>(k) & 3);
  switch (quadrant) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

double arc_tangent(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  if (ax == 0 && ay == 0) return 0;
  const double acute = ay <= ax ? arc_tangent_unit(ay / ax) : pi / 2 - arc_tangent_unit(ax / ay);
  const double upper = x < 0 ? pi - acute : acute;
  return y < 0 ? -upper : upper;
}

double exponential(double x) {
  constexpr double ln2_1 = 0x1.62e42feep-1, ln2_2 = 0x1.a39ef35793c76p-33;
  const double k = std::floor(x / (ln2_1 + ln2_2) + 0.5);
  const double r = (x - k * ln2_1) - k * ln2_2;
  double sum = 1;
  for (int n = 14; n >= 2; --n) sum = 1 + r * (1.0 / n) * sum;
  return std::ldexp(1 + r * sum, static_cast<int>(k));
}

double logarithm(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1), q = s * s;
  double sum = 0;
  for (int k = 23; k >= 3; k -= 2) sum = q * (1.0 / k + sum);
  constexpr double ln2 = 0.69314718055994530942;
  return exponent * ln2 + 2 * (s + s * sum);
}

}  // namespace lpq

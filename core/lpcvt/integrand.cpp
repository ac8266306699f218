// Closed form (method of [Levy, Liu 2010], section 4, written for the plane). A monomial of degree
// p over the triangle (0, u, v) integrates to
//   int y_1^p = |T| 2 / ((p + 1)(p + 2)) h_p(u_1, v_1),   h_p(a, b) = sum_{k=0..p} a^k b^(p-k),
// the complete homogeneous polynomial. Its derivatives come almost free:
//   h_k = a^k + b h_{k-1},   dh_k/db = h_{k-1} + b dh_{k-1}/db,   dh_p/da + dh_p/db = (p + 1)
//   h_{p-1}.
// For even p the absolute values of the L_p norm need no attention.
#include "lpcvt/integrand.h"

#include <cmath>

#include "base/check.h"
#include "numerics/elementary.h"
#include "numerics/power.h"

namespace lpq {
namespace {

struct Homogeneous {
  double value, da, db;
};

template <int P, int... K>
Homogeneous homogeneous(double a, double b, std::integer_sequence<int, K...>) {
  double power = 1, h = 1, db = 0, lower = 0;
  const auto raise = [&] {
    lower = h;
    db = h + b * db;
    power *= a;
    h = power + b * h;
  };
  ((static_cast<void>(K), raise()), ...);  // P times, unrolled whatever P
  return {h, (P + 1) * lower - db, db};
}

template <int P>
void closed_form(int count, PieceBlock& block) {
  constexpr double factor = 1.0 / ((P + 1) * (P + 2));
  for (int i = 0; i < count; ++i) {
    const double ux = block.ux[i], uy = block.uy[i], vx = block.vx[i], vy = block.vy[i];
    const Homogeneous x = homogeneous<P>(ux, vx, std::make_integer_sequence<int, P>{});
    const Homogeneous y = homogeneous<P>(uy, vy, std::make_integer_sequence<int, P>{});
    const double double_area = ux * vy - uy * vx;
    const double area = factor * double_area, sum = factor * (x.value + y.value);
    block.double_area[i] = double_area;
    block.energy[i] = double_area * sum;
    block.dux[i] = area * x.da + sum * vy;
    block.duy[i] = area * y.da - sum * vx;
    block.dvx[i] = area * x.db - sum * uy;
    block.dvy[i] = area * y.db + sum * ux;
  }
}

// |x|^(p-1) with the sign of x, for the exponents that have something better than logarithms.
template <int P>
struct EvenExponent {
  double operator()(double x) const { return integer_power(x, P - 1); }
};
struct IntegerExponent {
  int p;
  double operator()(double x) const {
    const double power = integer_power(std::abs(x), p - 1);
    return x < 0 ? -power : power;
  }
};
struct RealExponent {
  double p;
  double operator()(double x) const {
    if (x == 0) return 0;
    const double power = exponential((p - 1) * logarithm(std::abs(x)));
    return x < 0 ? -power : power;
  }
};

template <class SignedPower>
void gauss_sums(SignedPower power, double p, std::span<const TriangleNode> rule, int count,
                PieceBlock& block) {
  for (int i = 0; i < count; ++i) {
    const double ux = block.ux[i], uy = block.uy[i], vx = block.vx[i], vy = block.vy[i];
    double sum = 0, dux = 0, duy = 0, dvx = 0, dvy = 0;
    for (const TriangleNode& node : rule) {
      const double yx = node.u * ux + node.v * vx, yy = node.u * uy + node.v * vy;
      const double slope_x = node.weight * power(yx), slope_y = node.weight * power(yy);
      sum += slope_x * yx + slope_y * yy;
      dux += node.u * slope_x;
      duy += node.u * slope_y;
      dvx += node.v * slope_x;
      dvy += node.v * slope_y;
    }
    const double double_area = ux * vy - uy * vx;
    const double area = 0.5 * p * double_area, half = 0.5 * sum;
    block.double_area[i] = double_area;
    block.energy[i] = double_area * half;
    block.dux[i] = area * dux + half * vy;
    block.duy[i] = area * duy - half * vx;
    block.dvx[i] = area * dvx - half * uy;
    block.dvy[i] = area * dvy + half * ux;
  }
}

}  // namespace

bool has_closed_form(double p) { return p >= 2 && p <= 20 && 0.5 * p == std::floor(0.5 * p); }

void integrate_closed_form(int p, int count, PieceBlock& block) {
  switch (p) {
    case 2: return closed_form<2>(count, block);
    case 4: return closed_form<4>(count, block);
    case 6: return closed_form<6>(count, block);
    case 8: return closed_form<8>(count, block);
    case 10: return closed_form<10>(count, block);
    case 12: return closed_form<12>(count, block);
    case 14: return closed_form<14>(count, block);
    case 16: return closed_form<16>(count, block);
    case 18: return closed_form<18>(count, block);
    case 20: return closed_form<20>(count, block);
    default: LPQ_ASSERT(false);
  }
}

void integrate_gauss(double p, std::span<const TriangleNode> rule, int count, PieceBlock& block) {
  if (p != std::floor(p)) return gauss_sums(RealExponent{p}, p, rule, count, block);
  switch (static_cast<int>(p)) {
    case 2: return gauss_sums(EvenExponent<2>{}, p, rule, count, block);
    case 4: return gauss_sums(EvenExponent<4>{}, p, rule, count, block);
    case 6: return gauss_sums(EvenExponent<6>{}, p, rule, count, block);
    case 8: return gauss_sums(EvenExponent<8>{}, p, rule, count, block);
    default: return gauss_sums(IntegerExponent{static_cast<int>(p)}, p, rule, count, block);
  }
}

int gauss_degree(double p) {
  if (has_closed_form(p)) return static_cast<int>(p);
  constexpr int spare = 8;
  return static_cast<int>(std::ceil(p)) + spare;
}

}  // namespace lpq

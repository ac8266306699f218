// The area is a sum of cross products relative to the first corner. Its sign is certified by a
// running error bound and, where that is not enough, summed exactly as an expansion.
#include "geometry/polygon.h"

#include <cmath>
#include <vector>

#include "geometry/expansion.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

// Shewchuk's GROW-EXPANSION with zero elimination: components stay sorted and do not overlap.
void add_exactly(std::vector<double>& sum, double value) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const exact::Pair s = exact::two_sum(value, sum[i]);
    if (s.lo != 0) sum[kept++] = s.lo;
    value = s.hi;
  }
  sum.resize(kept);
  if (value != 0) sum.push_back(value);
}

int exact_orientation(std::span<const Vec2> polygon) {
  std::vector<double> sum;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const exact::Pair plus = exact::two_product(a.x, b.y), minus = exact::two_product(a.y, b.x);
    for (const double term : {plus.lo, -minus.lo, plus.hi, -minus.hi}) add_exactly(sum, term);
  }
  return sum.empty() ? 0 : (sum.back() > 0 ? 1 : -1);
}

}  // namespace

double signed_area(std::span<const Vec2> polygon) {
  double doubled = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    doubled += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * doubled;
}

int orientation(std::span<const Vec2> polygon) {
  double sum = 0, magnitude = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec2 u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    sum += cross(u, v);
    magnitude += std::abs(u.x * v.y) + std::abs(u.y * v.x);
  }
  // Each term carries at most 4 roundings and each addition one more: a bound with room to spare.
  constexpr double unit_roundoff = 0x1p-53;
  const double bound = unit_roundoff * (8 + 2 * static_cast<double>(polygon.size())) * magnitude;
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  return exact_orientation(polygon);
}

Side locate(Vec2 p, std::span<const Vec2> polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if (on_segment(p, a, b)) return Side::boundary;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const int side = orient2d(a, b, p);
    if ((b.y > a.y) == (side < 0)) inside = !inside;
  }
  return inside ? Side::inside : Side::outside;
}

}  // namespace lpq

// The predicates must give the exact sign for all doubles: compared with integer arithmetic, with
// their own symmetries, and where every floating filter fails.
#include "geometry/predicates.h"

#include <array>

#include "catch.h"
#include "geometry/predicates_inline.h"
#include "support/big_integer.h"
#include "support/point_sets.h"

using lpq::orient2d;
using lpq::Rng;
using lpq::Vec2;
using lpq_test::BigInteger;

namespace {

struct BigPoint {
  BigInteger x, y;
};

BigPoint operator-(const BigPoint& a, const BigPoint& b) { return {a.x - b.x, a.y - b.y}; }
BigInteger big_cross(const BigPoint& a, const BigPoint& b) { return a.x * b.y - a.y * b.x; }

// The coordinates times 2^scale must be integers.
BigPoint big(Vec2 p, int scale) { return {BigInteger::of(p.x, scale), BigInteger::of(p.y, scale)}; }

int orient_oracle(Vec2 a, Vec2 b, Vec2 c, int scale) {
  const BigPoint p = big(c, scale);
  return big_cross(big(a, scale) - p, big(b, scale) - p).sign();
}

int circle_oracle(Vec2 a, Vec2 b, Vec2 c, Vec2 d, int scale) {
  const BigPoint p = big(d, scale);
  const BigPoint u = big(a, scale) - p, v = big(b, scale) - p, w = big(c, scale) - p;
  const auto lift = [](const BigPoint& q) { return q.x * q.x + q.y * q.y; };
  return (lift(u) * big_cross(v, w) + lift(v) * big_cross(w, u) + lift(w) * big_cross(u, v)).sign();
}

void check_symmetries(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const int turn = orient2d(a, b, c);
  CHECK(orient2d(b, c, a) == turn);
  CHECK(orient2d(c, a, b) == turn);
  CHECK(orient2d(b, a, c) == -turn);
  CHECK(orient2d(a, c, b) == -turn);
  const int inside = lpq::in_circle_inline(a, b, c, d);
  CHECK(lpq::in_circle_inline(b, c, a, d) == inside);
  CHECK(lpq::in_circle_inline(b, a, c, d) == -inside);
  CHECK(lpq::in_circle_inline(a, b, d, c) == -inside);
  CHECK(lpq::in_circle_inline(d, b, c, a) == -inside);
}

}  // namespace

TEST_CASE("signs of simple configurations") {
  CHECK(orient2d({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(orient2d({0, 0}, {0, 1}, {1, 0}) == -1);
  CHECK(orient2d({0, 0}, {0.5, 0.5}, {3, 3}) == 0);
  CHECK(lpq::in_circle_inline({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}) == 1);
  CHECK(lpq::in_circle_inline({0, 0}, {1, 0}, {0, 1}, {2, 2}) == -1);
  CHECK(lpq::in_circle_inline({0, 0}, {1, 0}, {0, 1}, {1, 1}) == 0);
}

TEST_CASE("all signs on a small integer grid agree with integer arithmetic") {
  std::vector<Vec2> grid;
  for (int i = 0; i < 16; ++i) grid.push_back({double(i % 4), double(i / 4)});
  int wrong = 0;
  for (const Vec2 a : grid) {
    for (const Vec2 b : grid) {
      for (const Vec2 c : grid) {
        wrong += orient2d(a, b, c) != orient_oracle(a, b, c, 0);
        for (std::size_t i = 0; i < grid.size(); i += 3) {
          wrong += lpq::in_circle_inline(a, b, c, grid[i]) != circle_oracle(a, b, c, grid[i], 0);
        }
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("orientation on 128 x 128 grids of ulps along a diagonal") {
  // Kettner et al. 2008: the classroom example, where rounded arithmetic draws random patterns.
  const std::array<std::array<Vec2, 3>, 3> cases{
      {{{{0.5, 0.5}, {12, 12}, {24, 24}}},
       {{{0.5, 0.5}, {8.8125, 8.8125}, {12.125, 12.125}}},
       {{{0.25, 0.5}, {0.5, 1.0}, {3.0, 6.0}}}}};
  int wrong = 0, zeros = 0;
  for (const auto& [start, b, c] : cases) {
    for (int i = 0; i < 128; ++i) {
      for (int j = 0; j < 128; ++j) {
        const Vec2 a{start.x + i * 0x1p-53, start.y + j * 0x1p-53};
        const int sign = orient2d(a, b, c);
        wrong += sign != orient_oracle(a, b, c, 54);
        wrong += sign != orient2d(b, c, a) || sign != -orient2d(b, a, c);
        zeros += sign == 0;
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(zeros >= 128);
}

TEST_CASE("in-circle on grids of ulps around a fourth cocircular point") {
  int wrong = 0, exact_steps = 0;
  const Vec2 a{0.5, 0}, b{1, 0.5}, c{0.5, 1};
  for (int i = -32; i < 32; ++i) {
    for (int j = -32; j < 32; ++j) {
      const Vec2 d{std::abs(i) * 0x1p-54, 0.5 + j * 0x1p-53};
      const int sign = lpq::in_circle_inline(a, b, c, d);
      wrong += sign != circle_oracle(a, b, c, d, 54);
      wrong +=
          sign != lpq::in_circle_inline(b, c, a, d) || sign != -lpq::in_circle_inline(a, b, d, c);
      exact_steps += sign == 0;
    }
  }
  CHECK(wrong == 0);
  CHECK(exact_steps > 0);
}

TEST_CASE("random points sampled on circles, rounded to doubles") {
  Rng rng(3);
  int wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<Vec2, 4> p;
    const Vec2 centre{rng.between(0.3, 0.6), rng.between(0.3, 0.6)};
    for (Vec2& q : p) {
      const double t = rng.between(-3, 3), w = 1 + t * t;
      q = centre + 0.25 * Vec2{(1 - t * t) / w, 2 * t / w};
    }
    // Rounded to multiples of 2^-49, so that the oracle can use 64-bit integers.
    for (Vec2& q : p) q = {(q.x + 8) - 8, (q.y + 8) - 8};
    wrong +=
        lpq::in_circle_inline(p[0], p[1], p[2], p[3]) != circle_oracle(p[0], p[1], p[2], p[3], 60);
    wrong +=
        lpq::in_circle_exact(p[0], p[1], p[2], p[3]) != circle_oracle(p[0], p[1], p[2], p[3], 60);
  }
  CHECK(wrong == 0);
}

TEST_CASE("antisymmetry and cyclic invariance hold exactly") {
  Rng rng(4);
  const auto points = lpq_test::cocircular_points();
  const auto draw = [&](int kind) -> Vec2 {
    if (kind == 0) return {rng.unit(), rng.unit()};
    if (kind == 1) return 0.1 * points[rng.below(points.size())];  // nearly cocircular
    const double t = rng.unit();
    return {t, 0.3 * t + 0.1};  // nearly collinear
  };
  for (int i = 0; i < 3000; ++i) {
    const int kind = i % 3;
    const Vec2 a = draw(kind), b = draw(kind), c = draw(kind), d = draw(kind);
    check_symmetries(a, b, c, d);
  }
}

TEST_CASE("exact steps agree with the filters and with powers of two") {
  const auto p = lpq_test::random_points(4000, 5);
  for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
    CHECK(orient2d(p[i], p[i + 1], p[i + 2]) == lpq::orient2d_exact(p[i], p[i + 1], p[i + 2]));
    const int sign = lpq::in_circle_inline(p[i], p[i + 1], p[i + 2], p[i + 3]);
    CHECK(sign == lpq::in_circle_exact(p[i], p[i + 1], p[i + 2], p[i + 3]));
    CHECK(sign == lpq::in_circle_inline(0x1p40 * p[i], 0x1p40 * p[i + 1], 0x1p40 * p[i + 2],
                                        0x1p40 * p[i + 3]));
  }
}

TEST_CASE("cocircular points are cocircular, and a neighbour in the last place is not") {
  const auto p = lpq_test::cocircular_points();
  REQUIRE(p.size() == 36);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 a = p[i], b = p[(i + 7) % 36], c = p[(i + 16) % 36], d = p[(i + 25) % 36];
    CHECK(lpq::in_circle_inline(a, b, c, d) == 0);
    const int turn = orient2d(a, b, c);
    const Vec2 nearer{d.x * (1 - 0x1p-53), d.y * (1 - 0x1p-53)};
    const Vec2 farther{d.x * (1 + 0x1p-52), d.y * (1 + 0x1p-52)};
    CHECK(lpq::in_circle_inline(a, b, c, nearer) * turn == 1);
    CHECK(lpq::in_circle_inline(a, b, c, farther) * turn == -1);
  }
}

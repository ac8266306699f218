// Segments between the points of a small grid, all of them, against arithmetic of whole numbers.
#include "geometry/segment.h"

#include <vector>

#include "catch.h"

using namespace lpq;
using lpq_test::Approx;

namespace {

struct Place {
  int x, y;
};

Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
bool operator==(Place a, Place b) { return a.x == b.x && a.y == b.y; }
int cross_of(Place a, Place b) { return a.x * b.y - a.y * b.x; }
int dot_of(Place a, Place b) { return a.x * b.x + a.y * b.y; }

// Powers of two, and a translation that costs no bit.
Vec2 at(Place p) { return {0x1p-30 * p.x + 3, 0x1p-30 * p.y - 5}; }
Vec2 plain(Place p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

std::vector<Place> grid(int side) {
  std::vector<Place> points;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) points.push_back({x, y});
  return points;
}

template <class Visit>
void for_segments(Visit&& visit) {
  const std::vector<Place> points = grid(4);
  for (const Place a : points)
    for (const Place b : points)
      if (!(a == b)) visit(a, b);
}

/// Along the line of a and b, in units of the square of their distance.
Meeting meet_along(Place a, Place b, Place c, Place d) {
  const int whole = dot_of(b - a, b - a), of_c = dot_of(c - a, b - a), of_d = dot_of(d - a, b - a);
  const int first = std::max(0, std::min(of_c, of_d));
  const int last = std::min(whole, std::max(of_c, of_d));
  if (first > last) return Meeting::apart;
  return first == last ? Meeting::touching : Meeting::overlapping;
}

/// By the shares of both at which their lines meet: fractions with one denominator.
Meeting meet_by_shares(Place a, Place b, Place c, Place d) {
  int whole = cross_of(b - a, d - c);
  int of_ab = cross_of(c - a, d - c), of_cd = cross_of(c - a, b - a);
  if (whole == 0) return of_cd == 0 ? meet_along(a, b, c, d) : Meeting::apart;
  if (whole < 0) whole = -whole, of_ab = -of_ab, of_cd = -of_cd;
  if (of_ab < 0 || of_ab > whole || of_cd < 0 || of_cd > whole) return Meeting::apart;
  const bool inside = of_ab > 0 && of_ab < whole && of_cd > 0 && of_cd < whole;
  return inside ? Meeting::crossing : Meeting::touching;
}

}  // namespace

TEST_CASE("all pairs of segments on a grid meet as whole numbers say") {
  int wrong = 0, seen[4] = {};
  for_segments([&](Place a, Place b) {
    for_segments([&](Place c, Place d) {
      const Meeting expected = meet_by_shares(a, b, c, d);
      wrong += meet(at(a), at(b), at(c), at(d)) != expected;
      ++seen[static_cast<int>(expected)];
    });
  });
  CHECK(wrong == 0);
  for (const int pairs : seen) CHECK(pairs > 0);
}

TEST_CASE("how segments meet does not depend on which is first, nor on their directions") {
  int wrong = 0;
  for_segments([&](Place a, Place b) {
    for_segments([&](Place c, Place d) {
      const Meeting one = meet(at(a), at(b), at(c), at(d));
      wrong += meet(at(b), at(a), at(c), at(d)) != one;
      wrong += meet(at(a), at(b), at(d), at(c)) != one;
      wrong += meet(at(c), at(d), at(a), at(b)) != one;
    });
  });
  CHECK(wrong == 0);
}

TEST_CASE("a segment touches at its ends what they lie on, and what follows it") {
  const Vec2 a{0, 0}, b{1, 0}, c{2, 0}, up{0.5, 1};
  CHECK(meet(a, b, b, c) == Meeting::touching);
  CHECK(meet(a, b, b, up) == Meeting::touching);
  CHECK(meet(a, c, b, up) == Meeting::touching);
  CHECK(meet(a, c, a, b) == Meeting::overlapping);
  CHECK(meet(a, b, a, b) == Meeting::overlapping);
  CHECK(meet(a, b, {1 + 0x1p-52, 0}, c) == Meeting::apart);
  CHECK(meet(a, c, {1, 0x1p-1000}, up) == Meeting::apart);
}

TEST_CASE("points on segments and directions are exact") {
  int wrong = 0;
  for_segments([&](Place a, Place b) {
    for (const Place p : grid(4)) {
      const int along = dot_of(p - a, b - a);
      const bool in_line = cross_of(p - a, b - a) == 0;
      const bool inside = in_line && along >= 0 && along <= dot_of(b - a, b - a);
      wrong += on_segment(at(p), at(a), at(b)) != inside;
      if (!(p == a)) wrong += same_direction(at(a), at(b), at(p)) != (in_line && along > 0);
    }
  });
  CHECK(wrong == 0);
}

TEST_CASE("crossing points lie on both segments, to rounding") {
  double worst = 0;
  for_segments([&](Place a, Place b) {
    for_segments([&](Place c, Place d) {
      if (meet_by_shares(a, b, c, d) != Meeting::crossing) return;
      const Vec2 p = crossing_point(plain(a), plain(b), plain(c), plain(d));
      const Vec2 u = plain(b) - plain(a), v = plain(d) - plain(c);
      worst = std::max({worst, std::abs(cross(p - plain(a), u)), std::abs(cross(p - plain(c), v))});
    });
  });
  // Two products and a sum of numbers below 3 * 3, each within half an ulp of 16.
  CHECK(worst <= 4 * 0x1p-49);
  // In one line there is no such point: one of both instead.
  CHECK(crossing_point({0, 0}, {2, 0}, {1, 0}, {3, 0}) == Vec2{1, 0});
}

TEST_CASE("the closest point is an end, or the foot of a perpendicular") {
  int wrong = 0;
  double skew = 0;
  for_segments([&](Place a, Place b) {
    for (const Place p : grid(4)) {
      const int along = dot_of(p - a, b - a), whole = dot_of(b - a, b - a);
      const Vec2 foot = closest_point(plain(p), plain(a), plain(b));
      const double share = share_along(plain(p), plain(a), plain(b));
      wrong += along <= 0 && !(foot == plain(a) && share == 0);
      wrong += along >= whole && !(foot == plain(b) && share == 1);
      const double squared = squared_distance_to_segment(plain(p), plain(a), plain(b));
      skew = std::max(skew, std::abs(squared - squared_length(plain(p) - foot)));
      if (along > 0 && along < whole)
        skew = std::max(skew, std::abs(dot(plain(p) - foot, plain(b) - plain(a))));
    }
  });
  CHECK(wrong == 0);
  CHECK(skew <= 4 * 0x1p-49);
}

TEST_CASE("a segment without length is its one point") {
  const Vec2 a{0.1, 0.7}, p{3, 4};
  CHECK(closest_point(p, a, a) == a);
  CHECK(share_along(p, a, a) == 0);
  CHECK(squared_distance_to_segment(p, a, a) == squared_length(p - a));
  const Vec3 in_space{0.1, 0.7, -2};
  CHECK(share_along(Vec3{}, in_space, in_space) == 0);
}

TEST_CASE("shares in space are those of a plane that holds the segment and the point") {
  const Vec3 across{0, 3, 4};  // of length 5
  const auto lifted = [&](Vec2 p) { return Vec3{p.x, p.y / 5 * across.y, p.y / 5 * across.z}; };
  for_segments([&](Place a, Place b) {
    const Vec2 p{1.25, 0.5};
    const Vec3 q = lifted(p), c = lifted(plain(a)), d = lifted(plain(b));
    CHECK(share_along(q, c, d) == Approx(share_along(p, plain(a), plain(b))).margin(0x1p-50));
  });
}

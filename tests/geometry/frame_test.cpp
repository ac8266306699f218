// The unit frame is exact on the points it was fitted to, near and far from the origin.
#include "geometry/frame.h"

#include <cmath>
#include <vector>

#include "base/rng.h"
#include "catch.h"

using namespace lpq;

namespace {

void require_exact(Vec2 centre, double extent) {
  Rng rng(5);
  std::vector<Vec2> points;
  for (int i = 0; i < 500; ++i)
    points.push_back(centre + extent * Vec2{rng.between(-0.5, 0.5), rng.between(-0.5, 0.5)});
  const UnitFrame frame = fit_frame(points);
  for (const Vec2 p : points) {
    const Vec2 q = frame.to_frame(p);
    CHECK(frame.to_world(q) == p);
    CHECK(std::abs(q.x) <= 4);
    CHECK(std::abs(q.y) <= 4);
  }
}

}  // namespace

TEST_CASE("the frame's map is exact on every point and leads back to its bits") {
  for (const double extent : {1.0, 3e-7, 1e9})
    for (const Vec2 centre :
         {Vec2{0, 0}, Vec2{0.6, -0.4}, Vec2{1.5, 3}, Vec2{-100, 1e6}, Vec2{1e9, 1e9}})
      require_exact(extent * centre, extent);
}

TEST_CASE("the scale is a power of two, and snapping is idempotent") {
  const std::vector<Vec2> points{{1e6, 1}, {1e6 + 3, 2}};
  const UnitFrame frame = fit_frame(points);
  int exponent = 0;
  CHECK(std::frexp(frame.scale, &exponent) == 0.5);
  const Vec2 p = frame.snap({0.1234567890123, 0.3});
  CHECK(frame.snap(p) == p);
}

// Walks on a surface: straight on what is flat, and no farther than a barrier.
#include "shell/shape/walk.h"

#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"
#include "shell/place.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("walks on a flat surface are straight and stop at the border") {
  const SurfaceMesh square = plane_square(7);
  const std::vector<char> barrier(3 * square.triangles.size(), 0);
  const SurfaceWalker walker(square, barrier);
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const SurfacePlace start{static_cast<Index>(rng.below(square.triangles.size())),
                             {0.2, 0.3, 0.5}};
    const Vec3 from = point_at(square, start);
    const Vec3 way{rng.between(-0.6, 0.6), rng.between(-0.6, 0.6), 0};
    const TriangleAxes axes = axes_of(square, start.triangle);
    const WalkEnd end = walker.walk(start, {dot(way, axes.x), dot(way, axes.y)});
    const Vec3 goal = from + way, to = point_at(square, end.place);
    CHECK(end.whole == (goal.x > 0 && goal.x < 1 && goal.y > 0 && goal.y < 1));
    if (end.whole) CHECK(distance(goal, to) < 1e-12);
    CHECK(length(cross(to - from, way)) < 1e-12);
    const TriangleAxes last = axes_of(square, end.place.triangle);
    CHECK(distance(end.turn.x * last.x + end.turn.y * last.y, axes.x) < 1e-12);
  }
}

TEST_CASE("a walk round a pipe comes back, and a barrier stops it") {
  const int n = 24;
  const SurfaceMesh pipe = cylinder(n, 6, 1, 3);
  std::vector<char> barrier(3 * pipe.triangles.size(), 0);
  const double round = n * 2 * std::sin(turn / 2 / n);
  const SurfacePlace start{30, {0.3, 0.3, 0.4}};
  const Vec3 from = point_at(pipe, start);
  const TriangleAxes axes = axes_of(pipe, start.triangle);
  const Vec3 way = cross(Vec3{0, 0, 1}, axes.normal);
  const Vec2 flat = {round * dot(way, axes.x), round * dot(way, axes.y)};
  CHECK(distance(point_at(pipe, SurfaceWalker(pipe, barrier).walk(start, flat).place), from) <
        1e-12);
  for (Index e = 0; e < static_cast<Index>(barrier.size()); ++e)
    barrier[e] = pipe.points[pipe.origin(e)].x < -0.999 && pipe.points[pipe.target(e)].x < -0.999;
  const WalkEnd stopped = SurfaceWalker(pipe, barrier).walk(start, flat);
  CHECK(!stopped.whole);
  CHECK(point_at(pipe, stopped.place).x < -0.999);
}

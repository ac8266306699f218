// Sampling: gradients against finite differences, values outside, copies and moves.
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "field/make_fields.h"
#include "support/field_shapes.h"

using namespace lpq;
using namespace lpq::test;

namespace {

Fields some_fields() {
  auto result = make_fields(annulus_boundary(60, 50));
  REQUIRE(result.has_value());
  return std::move(*result);
}

bool inside(Vec2 p, double margin) {
  const double r = distance(p, {0.5, 0.5});
  return r < 0.49 - margin && r > 0.2 + margin;
}

}  // namespace

TEST_CASE("gradients match central differences") {
  const Fields fields = some_fields();
  Rng rng(3);
  int compared = 0;
  Index hint = none;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p{rng.unit(), rng.unit()};
    if (!inside(p, 0.01)) continue;
    const FieldSample s = fields.sample(p, hint);
    const double step = 1e-6;
    for (const Vec2 d : {Vec2{step, 0}, Vec2{0, step}}) {
      Index before = hint, after = hint;
      const FieldSample a = fields.sample(p - d, before), b = fields.sample(p + d, after);
      if (before != hint || after != hint) continue;  // a kink lies between
      const double turn = cross(a.axis, b.axis) * (dot(a.axis, b.axis) > 0 ? 1 : -1);
      const double slope = std::abs(dot(a.axis, b.axis)) > 0.5 ? turn : 0;
      const Vec2 along = (1 / step) * d;
      if (slope != 0) CHECK(std::abs(slope / (2 * step) - dot(s.grad_theta, along)) < 1e-4);
      CHECK(std::abs((b.h - a.h) / (2 * step * s.h) - dot(s.grad_log_h, along)) < 1e-4);
      ++compared;
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("the gradient of theta is capped at 1/h beside a singularity") {
  auto result = make_fields(disc_boundary(100));
  REQUIRE(result.has_value());
  for (const Singularity& s : result->singularities) {
    Index hint = none;
    for (int i = 0; i < 100; ++i) {
      const FieldSample f = result->sample(s.position + 1e-4 * Vec2{i - 50.0, 0.3 * i}, hint);
      CHECK(length(f.grad_theta) * f.h <= 1 + 1e-12);
      CHECK(std::abs(length(f.axis) - 1) < 1e-12);
    }
  }
}

TEST_CASE("a sample does not depend on the hint") {
  const Fields fields = some_fields();
  Rng rng(5);
  Index walking = none;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p{rng.unit(), rng.unit()};
    if (!inside(p, 0.001)) continue;
    Index fresh = none;
    const FieldSample a = fields.sample(p, walking), b = fields.sample(p, fresh);
    CHECK(length(a.axis - b.axis) < 1e-9);
    CHECK(std::abs(a.h - b.h) < 1e-12);
  }
}

TEST_CASE("outside the domain a sample is that of the nearest triangle") {
  const Fields fields = some_fields();
  double smallest = 1, largest = 0;
  for (const double h : fields.h) smallest = std::min(smallest, h), largest = std::max(largest, h);
  for (const Vec2 p : {Vec2{-3, 0.5}, Vec2{0.5, 0.5}, Vec2{2, 2}}) {
    Index hint = none;
    const FieldSample s = fields.sample(p, hint);
    CHECK(s.h >= smallest * (1 - 1e-12));
    CHECK(s.h <= largest * (1 + 1e-12));
    CHECK(hint != none);
  }
}

TEST_CASE("walk reaches what can be seen and nothing behind a wall") {
  const Fields fields = some_fields();
  Index from = none;
  fields.sample({0.15, 0.5}, from);
  CHECK(fields.walk({0.2, 0.55}, from) != none);
  CHECK(fields.walk({0.5, 0.5}, from) == none);   // the hole
  CHECK(fields.walk({-0.1, 0.5}, from) == none);  // outside
}

TEST_CASE("copies and moves sample their own background") {
  Fields original = some_fields();
  Index hint = none;
  const Vec2 p{0.2, 0.4};
  const FieldSample before = original.sample(p, hint);
  const Fields copy = original;
  const Fields moved = std::move(original);
  Fields assigned;
  assigned = copy;
  original = Fields();
  for (const Fields* f : {&copy, &moved, &static_cast<const Fields&>(assigned)}) {
    Index fresh = none;
    const FieldSample s = f->sample(p, fresh);
    CHECK(s.axis == before.axis);
    CHECK(s.h == before.h);
  }
}

TEST_CASE("a triangle whose area is rounded away has values") {
  // Its cross product is 0 in doubles; beside it a wide one.
  const double x = -0.01737584308700502, y = 0.0018810010044915206;
  Fields fields;
  fields.background.points = {{0, 0}, {x, y}, {2 * x, 2 * y}, {x, 1}};
  fields.background.triangles = {{0, 1, 2}, {0, 3, 1}};
  fields.background.twins = {5, none, none, none, none, 0};
  fields.background.region = {0, 0};
  fields.z.assign(4, {1, 0});
  fields.h = {0.1, 0.2, 0.3, 0.2};
  fields.attach();
  for (Index start = 0; start < 2; ++start)
    for (const Vec2 p :
         {Vec2{0.5 * x, 0.5 * y}, Vec2{x, y}, Vec2{1.5 * x, 1.5 * y}, Vec2{x, 0.5}}) {
      Index hint = start;
      const FieldSample s = fields.sample(p, hint);
      CHECK(is_finite(s.axis));
      CHECK(is_finite(s.grad_log_h));
      CHECK(s.h > 0.09);
      CHECK(s.h < 0.31);
    }
}

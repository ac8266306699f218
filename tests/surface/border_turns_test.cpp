// How borders of faces turn, from their steps alone.
#include "surface/border_turns.h"

#include <algorithm>
#include <array>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"

using namespace lpq;

namespace {

/// Every step a curve of its own.
std::vector<BorderStep> steps_of(const std::vector<std::array<double, 2>>& lengths_and_degrees) {
  std::vector<BorderStep> steps;
  for (const auto& [length, degrees] : lengths_and_degrees)
    steps.push_back({static_cast<Index>(steps.size()), length, degrees * pi / 180, true});
  return steps;
}

/// The other way round what lies on its other side: the turns stay, each at the other end.
std::vector<BorderStep> mirrored(std::vector<BorderStep> steps) {
  const double last = steps.back().turn;
  for (std::size_t k = steps.size(); --k > 0;) steps[k].turn = steps[k - 1].turn;
  steps[0].turn = last;
  std::reverse(steps.begin(), steps.end());
  return steps;
}

/// By how many right angles a border turns between the main parts of curves a and b.
Index turns_between(const FaceBorder& border, Index a, Index b) {
  const auto direction = [&](Index curve) {
    for (const BorderSide& side : border.sides)
      if (side.curve == curve) return side.main_direction();
    return Index{none};
  };
  return direction_after(direction(b) - direction(a));
}

}  // namespace

TEST_CASE("rounding does not decide how regular polygons turn") {
  Rng rng(5);
  for (int n = 5; n <= 40; ++n)
    for (const double length : {0.5, 0.75, 1.0, 1.5}) {
      INFO(n << " edges of " << length);
      std::vector<FaceBorder> borders;
      for (int trial = 0; trial < 20; ++trial) {
        std::vector<BorderStep> steps;
        for (int k = 0; k < n; ++k)
          steps.push_back({0, length * (1 + rng.between(-1e-14, 1e-14)),
                           2 * pi / n + rng.between(-1e-14, 1e-14), false});
        borders.push_back(border_of(steps));
      }
      for (const FaceBorder& border : borders) {
        CHECK(border.turns == borders[0].turns);
        CHECK(border.round == borders[0].round);
      }
    }
}

TEST_CASE("a border and its mirror image turn at the same places") {
  const auto steps = steps_of({{20, 65}, {10, 0}, {3, 65}, {15, 115}, {12, 115}});
  const FaceBorder one = border_of(steps), other = border_of(mirrored(steps));
  CHECK(one.turns == other.turns);
  for (const Index a : {0, 1, 3, 4})
    for (const Index b : {0, 1, 3, 4})
      CHECK(turns_between(one, a, b) == turns_between(other, b, a));
  CHECK(turns_between(one, 0, 1) == 1);
  CHECK(turns_between(one, 1, 3) == 1);
}

TEST_CASE("small circles are round, however uneven their vertices") {
  Rng rng(11);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<BorderStep> steps;
    for (double left = 2 * pi; left > 0;) {  // radians
      const double arc = std::min(left, rng.between(0.02, 0.15));
      steps.push_back({0, 2 * arc, arc, false});  // of a radius of two sizes
      left -= arc;
    }
    const FaceBorder border = border_of(steps);
    CHECK(border.round);
    CHECK(border.turns == 0);
  }
}

TEST_CASE("very fine borders are looked at once") {
  std::vector<BorderStep> steps(1 << 20);
  for (BorderStep& step : steps) step = {0, 3.0 / (1 << 20), 2 * pi / (1 << 20), false};
  const FaceBorder border = border_of(std::move(steps));
  CHECK(border.round);
}

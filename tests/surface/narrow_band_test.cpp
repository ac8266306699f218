// Which faces are ends of thin walls (surface/narrow_band.h).
#include "surface/narrow_band.h"

#include "catch.h"

namespace lpq {
namespace {

/// The border of a rectangle in mesh sizes, from its lower left corner: to the left all the way, or
/// as that of a hole to the right.
FaceBorder rectangle(double width, double height, bool is_hole) {
  FaceBorder border;
  border.turns = is_hole ? -right_angles_round : right_angles_round;
  border.length = 2 * (width + height);
  for (Index k = 0; k < right_angles_round; ++k) {
    BorderSide side;
    side.curve = k;
    side.length[k] = (k % 2 == 1) != is_hole ? height : width;
    border.sides.push_back(side);
  }
  return border;
}

/// Of the face between both.
std::optional<NarrowBand> band_between(const FaceBorder& outer, const FaceBorder& inner,
                                       double area) {
  const FaceBorder* const borders[] = {&inner, &outer};
  return narrow_band(borders, area);
}

}  // namespace

TEST_CASE("a thin wall's end is a narrow band, with a row of quads where one fits") {
  const FaceBorder outer = rectangle(40, 30, false);
  for (const double across : {0.1, 0.4, 0.6, 1.2}) {
    INFO(across << " sizes across");
    const double width = 40 - 2 * across, height = 30 - 2 * across;
    const FaceBorder inner = rectangle(width, height, true);
    const auto band = band_between(outer, inner, 40 * 30 - width * height);
    REQUIRE(band);
    CHECK(band->outer == &outer);
    CHECK(band->inner == &inner);
    CHECK(band->rows == (across < 0.5 ? 0 : 1));
  }
  const FaceBorder inner = rectangle(36, 26, true);
  CHECK_FALSE(band_between(outer, inner, 40 * 30 - 36 * 26));  // room for irregular vertices
}

TEST_CASE("a narrow face with a small hole somewhere is no narrow band") {
  const FaceBorder outer = rectangle(340, 1.2, false);
  for (const double hole : {0.005, 0.1, 0.6}) {
    const FaceBorder inner = rectangle(hole, hole, true);
    CHECK_FALSE(band_between(outer, inner, 340 * 1.2 - hole * hole));
  }
}

}  // namespace lpq

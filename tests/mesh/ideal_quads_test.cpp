#include "mesh/ideal_quads.h"

#include "catch.h"
#include "numerics/elementary.h"

using namespace lpq;

TEST_CASE("the switch angles are 120, 216 and 308.6 degrees") {
  const auto ideal = [](double degrees) { return ideal_quads(degrees * pi / 180); };
  CHECK(ideal(1) == 1);
  CHECK(ideal(90) == 1);
  CHECK(ideal(119.9) == 1);
  CHECK(ideal(120.1) == 2);
  CHECK(ideal(180) == 2);
  CHECK(ideal(215.9) == 2);
  CHECK(ideal(216.1) == 3);
  CHECK(ideal(270) == 3);
  CHECK(ideal(308.5) == 3);
  CHECK(ideal(308.7) == 4);
  CHECK(ideal(360) == 4);
}

TEST_CASE("the ideal always leaves room for strict convexity and minimises the worst ratio") {
  for (int degrees = 1; degrees <= 360; ++degrees) {
    const double angle = degrees * pi / 180;
    const Index k = ideal_quads(angle);
    CHECK(angle < k * pi);
    // |k quads: ratio to 90 degrees| as max(x, 1/x) is least among the neighbours, in the sense of
    // the harmonic rule: angle/k - 90 <= 90 - angle/(k+1).
    CHECK(angle / k - pi / 2 <= pi / 2 - angle / (k + 1) + 1e-12);
    if (k > 1) CHECK(angle / (k - 1) - pi / 2 > pi / 2 - angle / k - 1e-12);
  }
}

TEST_CASE("the fitting number of quads grows steadily and rounds to the ideal") {
  double before = 0;
  for (int degrees = 1; degrees < 360; ++degrees) {
    const double angle = degrees * pi / 180, fitting = fitting_quads(angle);
    CHECK(fitting > before);
    before = fitting;
    if (degrees >= 45 && degrees != 120 && degrees != 216)
      CHECK(ideal_quads(angle) == static_cast<Index>(fitting + 0.5));
    if (degrees % 90 == 0) CHECK(fitting == Approx(degrees / 90));
  }
}

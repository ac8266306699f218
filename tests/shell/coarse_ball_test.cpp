// A ball of six quads, each of which cuts off more than a good quad may.
#include <cmath>
#include <numbers>

#include "catch.h"
#include "shell/mesh_surface.h"
#include "shell/quality.h"

using namespace lpq;

namespace {

/// Of radius 1, by circles of latitude and longitude.
SurfaceSoup globe(int around, int down) {
  SurfaceSoup soup;
  soup.points.push_back({0, 0, 1});
  for (int j = 1; j < down; ++j)
    for (int i = 0; i < around; ++i) {
      const double polar = std::numbers::pi * j / down, turn = 2 * std::numbers::pi * i / around;
      soup.points.push_back(
          {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
    }
  soup.points.push_back({0, 0, -1});
  const Index south = static_cast<Index>(soup.points.size()) - 1;
  const auto at = [&](int j, int i) { return Index{1 + (j - 1) * around + i % around}; };
  for (int i = 0; i < around; ++i) {
    soup.triangles.push_back({0, at(1, i), at(1, i + 1)});
    soup.triangles.push_back({south, at(down - 1, i + 1), at(down - 1, i)});
    for (int j = 1; j + 1 < down; ++j) {
      soup.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      soup.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  }
  return soup;
}

}  // namespace

TEST_CASE("where every quad cuts off what is round there are no tips to reach") {
  for (const double h : {1.0, 1.2, 1.6}) {
    const auto outcome = mesh_surface(globe(48, 24), {.size = h});
    REQUIRE(outcome);
    CHECK(outcome->mesh.faces.size() <= 12);
    CHECK(outcome->report.shape.reached == 0);
    CHECK(shell_quality(outcome->mesh).eta_min > 0.9);
  }
}

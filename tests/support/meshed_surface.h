// A surface as the mesher leaves it, with what holds of every one.
#pragma once

#include <utility>

#include "catch.h"
#include "shell/check.h"
#include "shell/mesh_surface.h"

namespace lpq_test {

inline lpq::ShellOutcome meshed(const lpq::SurfaceSoup& soup, const lpq::SurfaceOptions& options) {
  auto outcome = lpq::mesh_surface(soup, options);
  INFO((outcome ? "" : outcome.error().message));
  REQUIRE(outcome.has_value());
  CHECK(lpq::check_shell(outcome->surface, outcome->mesh).empty());
  CHECK(outcome->report.quality.triangles == 0);
  CHECK(outcome->report.quality.nonconvex == 0);
  return *std::move(outcome);
}

}  // namespace lpq_test

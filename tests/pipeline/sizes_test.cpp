// Sizes at points, seen in the mesh: met where they are asked, and told where they are not; numbers
// of quads.
#include <cmath>

#include "catch.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "pipeline/session.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainInput sized(const Loop& outline, double h, std::vector<DomainInput::SizeAt> sizes) {
  DomainInput input;
  input.regions.push_back({"", {outline}, {}});
  input.h = h;
  input.sizes = std::move(sizes);
  return input;
}

Loop square(double side) { return {{0, 0}, {side, 0}, {side, side}, {0, side}}; }

// Side of the square of the area of the least face that holds the point.
double width_at(const OutputMesh& mesh, Vec2 p) {
  double least = 1e300;
  for (const Face& face : mesh.faces) {
    double area = 0;
    bool inside = true;
    for (int k = 0, n = corner_count(face); k < n; ++k) {
      const Vec2 a = mesh.points[face[k]] - p, b = mesh.points[face[(k + 1) % n]] - p;
      area += 0.5 * cross(a, b);
      inside = inside && cross(a, b) >= -1e-12;
    }
    if (inside) least = std::min(least, std::sqrt(area));
  }
  return least;
}

Outcome meshed(const DomainInput& input, const Options& options) {
  auto outcome = mesh_domain(input, options);
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  return std::move(*outcome);
}

Index count_ignored(const std::vector<Warning>& warnings) {
  Index count = 0;
  for (const Warning& warning : warnings) count += warning.code == ErrorCode::ignored;
  return count;
}

}  // namespace

TEST_CASE("a size at a point is met however fast sizes may grow") {
  const DomainInput inputs[] = {
      sized(square(4), 0.5, {{{2.03, 1.97}, 0.05}}),
      sized(square(4), 0.5, {{{1, 1}, 0.05}, {{3, 2.5}, 0.1}}),
      sized(square(4), 0.5, {{{2, 2}, 0.25}}),
      sized(square(10), 1, {{{5.1, 0.02}, 0.05}}),
      sized(circle({0, 0}, 1, 0.1), 0.15, {{{0.2, 0.1}, 0.02}}),
  };
  for (const DomainInput& input : inputs)
    for (const double growth : {0.3, 0.6, 2.0, 10.0}) {
      const Outcome outcome = meshed(input, {.growth = growth});
      for (const DomainInput::SizeAt& size : input.sizes)
        CHECK(width_at(outcome.mesh, size.position) < 1.6 * size.h);
      CHECK(outcome.report.quality.quads < 400);
    }
}

TEST_CASE("sizes outside the domain that ask for nothing there are told once") {
  const Vec2 near{1.02, 0.5}, far{7, 0.5};
  const Options options{.growth = 0.08};
  const auto warnings = [&](std::vector<DomainInput::SizeAt> sizes, const Options& how) {
    return meshed(sized(square(1), 0.1, std::move(sizes)), how).report.warnings;
  };
  // Inside, on the wall, or near enough to be felt.
  CHECK(count_ignored(warnings({{{0.5, 0.5}, 0.05}, {{1, 0.5}, 0.05}, {near, 0.05}}, options)) ==
        0);
  CHECK(count_ignored(warnings({{{0.5, 0.5}, 0.5}}, options)) == 0);
  const auto told = warnings({{near, 0.05}, {far, 0.05}, {{-4, 2}, 0.01}}, options);
  REQUIRE(count_ignored(told) == 1);
  CHECK(told.front().message.find("2 of 3") != std::string::npos);
  CHECK(told.front().where.has_point);
  CHECK(told.front().where.x == far.x);
  CHECK(told.front().where.y == far.y);
  CHECK(count_ignored(warnings({{{1e300, 0}, 0.05}}, options)) == 1);
}

TEST_CASE("beside a kept boundary its spacing says whether a size outside matters") {
  DomainInput input =
      sized(sampled_polygon(square(1), 0.125), 0, {{{1.5, 0.5}, 0.02}, {{9, 9}, 0.02}});
  const auto told = meshed(input, {.keep_boundary = true, .growth = 0.08}).report.warnings;
  REQUIRE(count_ignored(told) == 1);
  CHECK(told.front().where.x == 9);
}

TEST_CASE("about as many quads come as are asked for") {
  const DomainInput plain = sized(square(1), 0.5, {});
  const DomainInput painted = sized(square(1), 0.5, {{{0.3, 0.4}, 0.01}});
  const DomainInput kept = sized(sampled_polygon(square(1), 1.0 / 64), 0, {});
  const auto quads_of = [](const DomainInput& input, const Options& options) {
    return static_cast<double>(meshed(input, options).report.quality.quads);
  };
  for (const int quads : {100, 700, 3000})
    CHECK(quads_of(plain, {.quads = quads}) == Approx(double(quads)).epsilon(0.1));
  for (const double growth : {0.0, 0.3})
    CHECK(quads_of(painted, {.quads = 3000, .growth = growth}) == Approx(3000.0).epsilon(0.1));
  CHECK(quads_of(kept, {.quads = 2500, .keep_boundary = true}) == Approx(2500.0).epsilon(0.1));
}

TEST_CASE("numbers of quads that cannot be had are told") {
  const DomainInput fine = sized(sampled_polygon(square(1), 0.005), 0, {});
  const auto told = meshed(fine, {.quads = 50, .keep_boundary = true}).report.warnings;
  REQUIRE(told.size() == 1);
  CHECK(told.front().code == ErrorCode::adapted);
  CHECK(told.front().message.find("quads instead of 50") != std::string::npos);
  const auto both = mesh_domain(fine, {.size = 0.1, .quads = 50});
  REQUIRE_FALSE(both);
  CHECK(both.error().code == ErrorCode::bad_option);
}

TEST_CASE("an outline drawn far finer than the mesh is told, with what helps") {
  Loop fine;
  for (int i = 0; i < 1000; ++i) {
    const double t = 2 * std::acos(-1.0) * i / 1000;
    fine.push_back({3 * std::cos(t), 2 * std::sin(t)});
  }
  const DomainInput input = sized(fine, 0.3, {});
  const auto is_told = [&](const Options& options) {
    const Outcome outcome = meshed(input, options);
    Index count = 0;
    for (const Warning& warning : outcome.report.warnings) {
      count += warning.code == ErrorCode::adapted;
      if (warning.code == ErrorCode::adapted)
        CHECK(warning.message.find("simplify = 0.01") != std::string::npos);
    }
    CHECK(count <= 1);
    return count == 1;
  };
  CHECK(is_told({}));
  CHECK(is_told({.quads = 209}));
  CHECK_FALSE(is_told({.simplify = 0.01}));
  CHECK_FALSE(is_told({.size = 0.03}));
  CHECK_FALSE(is_told({.size = 0.3, .keep_boundary = true}));
}

TEST_CASE("a number of quads that the mesh misses is told with the number that it has") {
  const Outcome outcome = meshed(sized({{0, 0}, {4, 0}, {0, 3}}, 0, {}), {.quads = 20});
  const Index quads = outcome.report.quality.quads;
  REQUIRE(std::abs(quads - 20) > 4);
  REQUIRE(outcome.report.warnings.size() == 1);
  const std::string& message = outcome.report.warnings[0].message;
  CHECK(message.find("About " + std::to_string(quads) + " quads instead of 20") == 0);
}

TEST_CASE("sizes that doubles cannot hold are refused at points, too") {
  const auto code = [](double h) {
    const auto outcome = mesh_domain(sized(square(1), 0.1, {{{0.37, 0.41}, h}}));
    return outcome ? ErrorCode::cancelled : outcome.error().code;
  };
  CHECK(code(1e-15) == ErrorCode::lost_precision);
  CHECK(code(1e-300) == ErrorCode::lost_precision);
  CHECK(code(1e-3) == ErrorCode::cancelled);
}

TEST_CASE("the energy of the least sizes is a number, and zero where no L_p runs") {
  for (const double h : {1e-13, 1e-14}) {
    DomainInput input = sized(square(1), 0.1, {{{0.37, 0.41}, h}});
    input.seeds = {{0.37, 0.41}, {0.2, 0.2}};
    auto session = Session::start(input, {.norm = 20});
    REQUIRE(session);
    REQUIRE(session->step(1));
    REQUIRE(session->mesher().stage() == Stage::optimise);
    CHECK(session->mesher().iterations() == 0);
    for (const double value : {session->mesher().energy(), session->mesher().gradient_norm()}) {
      CHECK(value > 0);
      CHECK(std::isfinite(value));
    }
  }
  auto aligned = Session::start(sized(square(1), 0.1, {}));
  REQUIRE(aligned);
  for (int step = 0; step < 2; ++step) {
    CHECK(aligned->mesher().iterations() == 0);
    CHECK(aligned->mesher().energy() == 0);
    CHECK(aligned->mesher().gradient_norm() == 0);
    REQUIRE(aligned->step(1));
  }
}

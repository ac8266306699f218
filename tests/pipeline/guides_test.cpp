// Guides through the whole chain: no clean-up, patch or smoothing undoes what was drawn.
#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.h"
#include "pipeline/finish.h"
#include "pipeline/mesh_domain.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

using Guide = UserFields::Guide;

Guide arc(Vec2 centre, double radius) {
  Guide guide;
  for (int i = 0; i <= 40; ++i) {
    const double a = 0.9 + 0.0325 * i;
    guide.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return guide;
}

struct Nearest {
  double distance = 1e300;
  Vec2 direction;
};

Nearest nearest_on(const Guide& guide, Vec2 p) {
  Nearest best;
  for (std::size_t i = 1; i < guide.size(); ++i) {
    const Vec2 d = guide[i] - guide[i - 1];
    const double s = std::clamp(dot(p - guide[i - 1], d) / squared_length(d), 0.0, 1.0);
    const double r = distance(p, guide[i - 1] + s * d);
    if (r < best.distance) best = {r, d};
  }
  return best;
}

// Degrees between the sides of quads with their middle within h of the guide and the guide, up to
// quarter turns: the median.
double median_angle(const OutputMesh& mesh, const Guide& guide, double h) {
  std::vector<double> angles;
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 4; ++k) {
      const Vec2 a = mesh.points[face[k]], b = mesh.points[face[(k + 1) & 3]];
      const Nearest at = nearest_on(guide, midpoint(a, b));
      if (at.distance > h) continue;
      const double turn =
          std::abs(std::atan2(cross(b - a, at.direction), dot(b - a, at.direction)));
      const double quarter = std::fmod(turn * 180 / std::numbers::pi, 90);
      angles.push_back(std::min(quarter, 90 - quarter));
    }
  REQUIRE(angles.size() > 50);
  std::nth_element(angles.begin(), angles.begin() + angles.size() / 2, angles.end());
  return angles[angles.size() / 2];
}

Outcome guided(const DomainInput& input, const Options& options, const UserFields& user) {
  auto outcome = mesh_domain(input, options, {}, nullptr, user);
  REQUIRE(outcome);
  CHECK(check_output(outcome->mesh).empty());
  CHECK(outcome->report.quality.triangles == 0);
  return std::move(*outcome);
}

void check_followed(const DomainInput& input, const Guide& guide) {
  for (const double h : {0.05, 0.03}) {
    UserFields user;
    user.guides = {guide};
    const Outcome outcome = guided(input, {.size = h}, user);
    CHECK(median_angle(outcome.mesh, guide, h) < 5);
    CHECK(outcome.report.quality.eta_mean > 0.88);
    CHECK(outcome.report.quality.eta_min > 0.3);
  }
}

}  // namespace

TEST_CASE("quads of a square follow strokes") {
  const DomainInput input = square(1, 0.2);
  check_followed(input, {{0.3, 0.3}, {0.7, 0.7}});
  check_followed(input, {{0.15, 0.15}, {0.85, 0.85}});
  check_followed(input, {{0.25, 0.35}, {0.75, 0.65}});
  check_followed(input, arc({0.5, 0.1}, 0.45));
}

TEST_CASE("quads of a disc follow strokes") {
  const DomainInput input = disc(0.1);
  check_followed(input, {{-0.25, -0.25}, {0.25, 0.25}});
  check_followed(input, {{-0.3, -0.15}, {0.3, 0.15}});
  check_followed(input, arc({0, -0.5}, 0.55));
}

TEST_CASE("quads of a plate with a hole follow strokes", "[slow]") {
  const DomainInput input = plate_with_hole(0.1);
  check_followed(input, {{1.1, 0.2}, {1.7, 0.8}});
  check_followed(input, {{1.1, 0.35}, {1.8, 0.65}});
  check_followed(input, arc({1.4, 0.05}, 0.5));
}

TEST_CASE("strokes are followed with a kept boundary, high effort and the paper's chain") {
  const Guide slanted{{0.25, 0.35}, {0.75, 0.65}};
  UserFields user;
  user.guides = {slanted};
  for (const Options& options : {Options{.keep_boundary = true}, Options{.effort = Effort::high},
                                 Options{.method = Method::paper}})
    CHECK(median_angle(guided(square(1, 0.04), options, user).mesh, slanted, 0.04) < 5);
}

TEST_CASE("guides and sizes may come with the domain; the caller's win") {
  const Guide one{{0.3, 0.3}, {0.7, 0.7}}, other{{0.2, 0.6}, {0.8, 0.5}};
  const std::vector<UserFields::SizeAt> fine{{{0.5, 0.5}, 0.02}}, coarse{{{0.5, 0.5}, 0.04}};
  const auto hash = [](const DomainInput& input, const UserFields& user) {
    return guided(input, {.size = 0.05}, user).report.hash;
  };
  const DomainInput plain = square(1, 0.05);
  DomainInput carrying = plain;
  carrying.guides = {other};
  carrying.sizes = coarse;
  UserFields user, same;
  user.guides = {one};
  user.sizes = fine;
  same.guides = {other};
  same.sizes = coarse;
  CHECK(hash(carrying, {}) == hash(plain, same));
  CHECK(hash(carrying, {}) != hash(plain, {}));
  CHECK(hash(carrying, user) == hash(plain, user));
}

TEST_CASE("a guide outside the domain changes no bit") {
  UserFields user;
  user.guides = {{{3, 3}, {4, 5}}, {{-1, 2}, {5, 2}}};
  CHECK(guided(disc(0.05), {}, user).report.hash == guided(disc(0.05), {}, {}).report.hash);
}

TEST_CASE("guides that no part of the domain follows are told, with the first") {
  const Guide inside{{0.2, 0.2}, {0.8, 0.7}}, through{{-1, 0.4}, {2, 0.6}}, far{{3, 3}, {4, 5}};
  UserFields user;
  const auto warnings = [&] { return guided(square(1, 0.1), {}, user).report.warnings; };
  user.guides = {inside, through};
  CHECK(warnings().empty());
  user.guides = {inside, far, {{-9, 2}, {-8, 2}}};
  const auto told = warnings();
  REQUIRE(told.size() == 1);
  CHECK(told[0].code == ErrorCode::ignored);
  CHECK(told[0].message.find("2 of 3 guides lie outside") == 0);
  CHECK(told[0].where.guide == 1);
  CHECK(told[0].where.x == 3);
  user.angle = [](Vec2) { return 0.0; };  // wins over all of them
  CHECK(warnings().empty());
}

TEST_CASE("a guide without a direction is refused at its place among the caller's coordinates") {
  UserFields user;
  user.guides = {{{300, 300}, {400, 410}}, {{350, 301}, {350, 301}}};
  const auto outcome = mesh_domain(square(1000, 50), {}, {}, nullptr, user);
  REQUIRE(!outcome.has_value());
  CHECK(outcome.error().code == ErrorCode::bad_option);
  CHECK(outcome.error().where.guide == 1);
  CHECK(outcome.error().where.x == 350);
  CHECK(outcome.error().where.y == 301);
}

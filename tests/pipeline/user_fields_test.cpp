// What callers say of sizes and directions is judged at the door, before anything is allocated.
#include <cmath>
#include <limits>

#include "catch.h"
#include "pipeline/mesh_domain.h"

using namespace lpq;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

DomainInput plate() {
  DomainInput input;
  input.regions.push_back({"", {{{0, 0}, {10, 0}, {10, 4}, {0, 4}}}, {}});
  return input;
}

UserFields even_sizes(double detail) {
  UserFields user;
  user.size = [](Vec2) { return 0.3; };
  user.detail = detail;
  return user;
}

/// parse_error where there is none.
ErrorCode refusal(const UserFields& user, const Options& options = {}) {
  const auto outcome = mesh_domain(plate(), options, {}, nullptr, user);
  return outcome ? ErrorCode::parse_error : outcome.error().code;
}

}  // namespace

TEST_CASE("a detail that is no length is refused, with and without a size function") {
  for (const double detail : {-1.0, -1e-300, infinity, -infinity, std::nan("")}) {
    CAPTURE(detail);
    CHECK(refusal(even_sizes(detail)) == ErrorCode::bad_option);
    UserFields user;
    user.detail = detail;
    CHECK(refusal(user) == ErrorCode::bad_option);
  }
}

TEST_CASE("a detail of which the background would fill the machine is refused") {
  for (const double detail : {0.01, 0.005, 1e-9, 1e-200, 5e-324}) {
    CAPTURE(detail);
    CHECK(refusal(even_sizes(detail)) == ErrorCode::too_many_elements);
  }
  // In proportion to the elements allowed.
  CHECK(refusal(even_sizes(0.015), {.max_elements = 10000}) == ErrorCode::too_many_elements);
  for (const double detail : {0.0, 0.05, 100.0}) {
    CAPTURE(detail);
    CHECK(mesh_domain(plate(), {}, {}, nullptr, even_sizes(detail)));
  }
  UserFields unused;  // no function, nothing to look at
  unused.detail = 1e-9;
  CHECK(mesh_domain(plate(), {.size = 0.5}, {}, nullptr, unused));
}

TEST_CASE("a stretch that is not a vector shorter than 1 is refused where it is") {
  for (const Vec2 mu : {Vec2{std::nan(""), 0}, {0, std::nan("")}, {infinity, 0}, {0.8, 0.8}}) {
    CAPTURE(mu.x, mu.y);
    UserFields user;
    user.stretch = [mu](Vec2) { return mu; };
    CHECK(refusal(user, {.size = 0.5}) == ErrorCode::non_finite);

    user.stretch = [mu](Vec2 p) {  // not on the walls
      return distance(p, {5, 2}) < 1 ? mu : Vec2{0.1, 0};
    };
    const auto outcome = mesh_domain(plate(), {.size = 0.5}, {}, nullptr, user);
    REQUIRE(!outcome);
    CHECK(outcome.error().code == ErrorCode::non_finite);
    CHECK(distance({outcome.error().where.x, outcome.error().where.y}, Vec2{5, 2}) < 1);
  }
}

TEST_CASE("options that are no value of their enum are refused") {
  for (const int number : {-1, 3, 17}) {
    CAPTURE(number);
    CHECK(refusal({}, {.elements = static_cast<Elements>(number)}) == ErrorCode::bad_option);
    CHECK(refusal({}, {.method = static_cast<Method>(number)}) == ErrorCode::bad_option);
    CHECK(refusal({}, {.effort = static_cast<Effort>(number)}) == ErrorCode::bad_option);
    CHECK(refusal({}, {.seeds = static_cast<Seeds>(number)}) == ErrorCode::bad_option);
  }
}

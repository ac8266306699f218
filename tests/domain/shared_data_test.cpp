// Every labelled domain of the shared data gets the verdict that its label asks for.
#include "catch.h"
#include "domain/boundary.h"
#include "domain_data.h"

using namespace lpq;
using namespace lpq_test;

TEST_CASE("invalid domains are refused with the code of their label") {
  for (const auto& path : shared_domains("invalid")) {
    INFO(path.filename());
    const std::string text = read_text(path);
    const std::string action = json_member(text, "action"), code = json_member(text, "code");
    // The labels take the first loop for the outer one.
    const auto domain = make_domain(read_domain(path), {.outer_first = true});
    if (code == "DUPLICATE_POINT") {
      CHECK(domain.has_value());
      const auto strict = make_domain(read_domain(path), {.strict = true, .outer_first = true});
      // Only the repeated closing point is nothing to speak of.
      if (domain && domain->warnings.empty()) {
        CHECK(strict.has_value());
      } else {
        REQUIRE_FALSE(strict.has_value());
        CHECK(strict.error().code == ErrorCode::duplicate_point);
      }
      continue;
    }
    REQUIRE_FALSE(domain.has_value());
    INFO(domain.error().message);
    CHECK(code_name(domain.error().code) == code);
    CHECK(domain.error().where.loop != none);
    CHECK(domain.error().where.has_point);
  }
}

TEST_CASE("valid domains are accepted and keep every bit") {
  for (const auto& path : shared_domains("polygons")) {
    INFO(path.filename());
    const DomainInput input = read_domain(path);
    const auto domain = make_domain(input);
    INFO((domain ? std::string() : domain.error().message));
    REQUIRE(domain.has_value());
    CHECK(domain->warnings.empty());
    std::vector<Vec2> in_order(domain->points.size());
    for (std::size_t i = 0; i < domain->points.size(); ++i) {
      in_order[domain->output_rank[i]] = domain->given[i];
      CHECK(domain->frame.to_world(domain->points[i]) == domain->given[i]);
    }
    std::size_t next = 0;
    for (const Loop& loop : input.regions[0].loops)
      for (const Vec2 p : loop) {
        REQUIRE(next < in_order.size());
        CHECK(in_order[next++] == p);
      }
    CHECK(next == in_order.size());
  }
}

// The search for the size that gives a number of quads.
#include <cmath>

#include "catch.h"
#include "field/size_for_count.h"

using namespace lpq;

namespace {

constexpr double largest = 10;

/// Of walls that ask for `own` quads by themselves, and an area of `area` that does not.
struct Counted {
  double own = 0, area = 0;
  int calls = 0;
  Result<double> operator()(double size) {
    ++calls;
    return own + area / (size * size);
  }
};

SizeForCount found(Counted& counted, double first, double wanted) {
  const auto size = size_for_count(first, largest, wanted, counted);
  REQUIRE(size);
  return *size;
}

}  // namespace

TEST_CASE("a size is found for a number of quads, whatever the walls ask for") {
  for (const double own : {0.0, 30.0, 500.0, 990.0})
    for (const double first : {0.01, 0.1, 3.0}) {
      Counted counted{own, 8};
      const SizeForCount answer = found(counted, first, 1000);
      CHECK(std::abs(answer.quads - 1000) <= 10);
      CHECK(std::abs(own + 8 / (answer.size * answer.size) - answer.quads) < 1e-9);
      CHECK(counted.calls <= 8);
      CHECK_FALSE(judge_count(answer.quads, 1000));
    }
}

TEST_CASE("what asks for more by itself gets the largest size, and is told") {
  Counted counted{5000, 8};
  const SizeForCount answer = found(counted, 0.1, 1000);
  CHECK(answer.size > 0.5 * largest);
  CHECK(answer.size <= largest);
  const Problem told = judge_count(answer.quads, 1000);
  REQUIRE(told);
  CHECK(told->code == ErrorCode::adapted);
  CHECK(told->message.find("About 5000 quads instead of 1000") == 0);
}

TEST_CASE("sizes that leave nothing to choose are told") {
  Counted counted{100, 0};
  const Problem told = judge_count(found(counted, 0.1, 1000).quads, 1000);
  REQUIRE(told);
  CHECK(told->message.find("100 quads instead of 1000") != std::string::npos);
}

TEST_CASE("the search ends where sizes cannot be judged") {
  const auto refused = [](double) -> Result<double> { return Error{ErrorCode::bad_size, "", {}}; };
  const auto size = size_for_count(1, largest, 10, refused);
  REQUIRE_FALSE(size);
  CHECK(size.error().code == ErrorCode::bad_size);
}

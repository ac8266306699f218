#include "io/number.h"

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/rng.h"
#include "catch.h"

using namespace lpq;

namespace {

std::string text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void require_round_trip(double value) {
  double back = 0;
  INFO(text_of(value));
  REQUIRE(parse_number(text_of(value), back));
  REQUIRE(same_bits(value, back));
}

double from_bits(std::uint64_t bits) {
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace

TEST_CASE("numbers read back bit for bit") {
  for (const double value :
       {0.0, -0.0, 1.0, -1.0, 0.1, 1.0 / 3, 1e300, -1e-300, 5e-324, 0x1p53, 0x1p53 + 2, 0x1p-1074,
        std::numeric_limits<double>::max(), 123456.789, 0.000001, 1e-7, 9007199254740993.0}) {
    require_round_trip(value);
  }
  Rng rng(7);
  for (int i = 0; i < 20000; ++i) {
    const double any = from_bits(rng.next());
    if (std::isfinite(any)) require_round_trip(any);
    require_round_trip(rng.between(-2, 2));
    require_round_trip(std::floor(rng.between(-1e7, 1e7)) / 1000);  // short decimals
  }
}

TEST_CASE("short decimals are printed short") {
  CHECK(text_of(0.1) == "0.1");
  CHECK(text_of(-0.025) == "-0.025");
  CHECK(text_of(0.000001) == "0.000001");
  CHECK(text_of(100) == "100");
  CHECK(text_of(-0.0) == "-0");
  CHECK(text_of(0.1 + 0.2) == "0.30000000000000004");
}

TEST_CASE("a locale with a decimal comma changes nothing") {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  bool found = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_NUMERIC, name) == nullptr) continue;
    found = true;
    CHECK(text_of(1.0 / 3) == "0.33333333333333331");
    require_round_trip(1.0 / 3);
    require_round_trip(2.5e-9);
    break;
  }
  std::setlocale(LC_NUMERIC, before.c_str());
  if (!found) WARN("SKIPPED: no locale with a decimal comma because none is installed");
}

TEST_CASE("only whole decimal numbers are read") {
  double value = 0;
  for (const char* text : {"1", "-1.5", "+2", ".5", "5.", "1e3", "1E-3", "0005", "1e-400"}) {
    INFO(text);
    CHECK(parse_number(text, value));
  }
  for (const char* text : {"", " 1", "1 ", "nan", "inf", "-inf", "0x10", "1e", "1e+", ".", "-",
                           "+-1", "1,5", "1e400", "1.2.3", "1f", "١"}) {
    INFO(text);
    CHECK_FALSE(parse_number(text, value));
  }
  std::int64_t integer = 0;
  CHECK((parse_integer("-9223372036854775808", integer) && integer == INT64_MIN));
  for (const char* text : {"", "1.0", "9223372036854775808", "1 ", "+", "++1", "+-1", "0x1"})
    CHECK_FALSE(parse_integer(text, integer));
}

TEST_CASE("fixed decimals are rounded and trimmed") {
  const auto fixed = [](double value, int decimals) {
    std::string text;
    append_fixed(text, value, decimals);
    return text;
  };
  CHECK(fixed(1.005, 1) == "1");
  CHECK(fixed(3.14159, 2) == "3.14");
  CHECK(fixed(0.05, 2) == "0.05");
  CHECK(fixed(-0.001, 2) == "0");
  CHECK(fixed(-2.5, 2) == "-2.5");
  CHECK(fixed(std::numeric_limits<double>::quiet_NaN(), 2) == "0");
}

// Numbers in columns, and names as labels.
#include "io/number_field.h"

#include <cmath>
#include <cstring>
#include <set>
#include <tuple>
#include <vector>

#include "base/rng.h"
#include "catch.h"
#include "io/mesh/labels.h"
#include "io/number.h"

using namespace lpq;

namespace {

std::string field(double value, std::size_t width, const char* mark) {
  std::string text;
  append_number_field(text, value, width, mark);
  return text;
}

/// The number as Nastran reads it: a sign inside is an exponent's.
double read_back(std::string text) {
  const std::size_t sign = text.find_last_of("+-");
  if (sign != std::string::npos && sign > 0 && text[sign - 1] != 'e') text.insert(sign, "e");
  double value = NAN;
  REQUIRE(parse_number(text, value));
  return value;
}

}  // namespace

TEST_CASE("short numbers stand in a column as they are") {
  CHECK(field(0, 16, "") == "0.0");
  CHECK(field(1, 16, "") == "1.0");
  CHECK(field(-2.5, 16, "") == "-2.5");
  CHECK(field(0.1, 16, "") == "0.1");
}

TEST_CASE("numbers keep to their column and as many digits as fit") {
  Rng rng(7);
  for (int i = 0; i < 20'000; ++i) {
    const double decades = 40 * (rng.unit() - 0.5);
    double value = rng.unit() - 0.5;
    for (int k = 0; k < std::abs(static_cast<int>(decades)); ++k)
      value = decades < 0 ? value / 10 : value * 10;
    for (const auto& [width, mark, digits] :
         {std::tuple{16, "", 1e-10}, {20, "e", 1e-13}, {8, "", 0.06}}) {
      const std::string text = field(value, static_cast<std::size_t>(width), mark);
      INFO(value << " " << text);
      REQUIRE(text.size() <= static_cast<std::size_t>(width));
      REQUIRE(text.find('.') != std::string::npos);
      REQUIRE(std::fabs(read_back(text) - value) <= digits * std::fabs(value));
    }
  }
}

TEST_CASE("a column of 20 gives doubles of everyday size back bit for bit") {
  Rng rng(8);
  for (int i = 0; i < 20'000; ++i) {
    const double value = 1 + 1000 * rng.unit();
    REQUIRE(read_back(field(value, 20, "e")) == value);
    REQUIRE(read_back(field(-value, 20, "e")) == -value);
    REQUIRE(std::fabs(read_back(field(value, 16, "")) - value) <= 1e-14 * value);
  }
}

TEST_CASE("the largest and the smallest numbers fit as well") {
  for (const double value : {1.7976931e308, 2.2250738585072014e-308, 5e-324, 1e22, 1e23, 0.1 + 0.2,
                             1.0 / 3, 9.9999999999999999e9, 123456789012345680.0}) {
    for (const double signed_value : {value, -value}) {
      const std::string text = field(signed_value, 16, "");
      INFO(text);
      CHECK(text.size() <= 16);
      CHECK(std::fabs(read_back(text) - signed_value) <= 1e-9 * value + 5e-324);
    }
  }
}

TEST_CASE("labels are short, plain and unique whatever the names are") {
  Labels labels(80);
  std::set<std::string> seen;
  const std::vector<std::string> names{"steel",
                                       "Steel",
                                       "STEEL",
                                       "steel_2",
                                       "steel 2",
                                       "",
                                       " ",
                                       "\xE6\x97\xA5",
                                       "\xFF",
                                       "1",
                                       "*NODE",
                                       "a,b\n=c",
                                       std::string(500, 'x'),
                                       std::string(500, 'x') + "y"};
  for (const std::string& name : names) {
    const std::string label = labels.add(name);
    INFO(label);
    CHECK(label.size() <= 80);
    CHECK(std::isalpha(label[0]) != 0);
    CHECK(label.find_first_not_of(
              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") ==
          std::string::npos);
    std::string lower;
    for (const char c : label) lower += static_cast<char>(std::tolower(c));
    CHECK(seen.insert(lower).second);
  }
  CHECK(Labels(80).add("Inlet 1") == "Inlet_1");
}

TEST_CASE("many equal names become labels in no time") {
  Labels labels(10);
  std::set<std::string> seen;
  for (int i = 0; i < 20'000; ++i) {
    const std::string label = labels.add("a name too long");
    REQUIRE(label.size() <= 10);
    REQUIRE(seen.insert(label).second);
  }
}

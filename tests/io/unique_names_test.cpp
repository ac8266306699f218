#include "io/unique_names.h"

#include <set>

#include "catch.h"

using namespace lpq;

TEST_CASE("names given once stay as they are, others get a number") {
  UniqueNames names;
  CHECK(names.add("steel") == "steel");
  CHECK(names.add("Steel") == "Steel");
  CHECK(names.add("steel") == "steel_2");
  CHECK(names.add("steel") == "steel_3");
  CHECK(names.add("") == "");
  CHECK(names.add("") == "_2");
}

TEST_CASE("a number is not one that another name has") {
  UniqueNames names;
  CHECK(names.add("a_2") == "a_2");
  CHECK(names.add("a") == "a");
  CHECK(names.add("a") == "a_3");
  CHECK(names.add("a_3") == "a_3_2");
}

TEST_CASE("where a format knows one case names differ by more than that") {
  UniqueNames names(std::string::npos, UniqueNames::Case::does_not);
  CHECK(names.add("steel") == "steel");
  CHECK(names.add("STEEL") == "STEEL_2");
  CHECK(names.add("Steel") == "Steel_3");
}

TEST_CASE("no name is longer than the format holds, and none ends within a letter") {
  constexpr std::size_t longest = 8;
  UniqueNames names(longest);
  std::set<std::string> seen;
  for (int i = 0; i < 1200; ++i) {
    const std::string name = names.add("h\xC3\xB6hlen-\xC3\xA4hnlich");
    CHECK(name.size() <= longest);
    CHECK((static_cast<unsigned char>(name.back()) & 0xC0) != 0xC0);
    CHECK(seen.insert(name).second);
  }
  CHECK(seen.count("h\xC3\xB6hlen-") == 1);
}

#include "base/nearest_name.h"

#include <vector>

#include "catch.h"

using lpq::nearest_name;

namespace {
const std::vector<std::string> names{"size", "seeds", "smoothing", "keepBoundary", "quads"};
}

TEST_CASE("a name with a letter missing, added, replaced or swapped is the one that is meant") {
  for (const std::string& name : names)
    for (std::size_t i = 0; i < name.size(); ++i) {
      CHECK(nearest_name(name.substr(0, i) + name.substr(i + 1), names) == name);
      CHECK(nearest_name(name.substr(0, i) + "x" + name.substr(i), names) == name);
      std::string other = name;
      other[i] = 'x';
      CHECK(nearest_name(other, names) == name);
      if (i == 0) continue;
      other = name;
      std::swap(other[i - 1], other[i]);
      CHECK(nearest_name(other, names) == name);
    }
}

TEST_CASE("the beginning of a name means it, from four letters on") {
  CHECK(nearest_name("keep", names) == "keepBoundary");
  CHECK(nearest_name("keepBound", names) == "keepBoundary");
  CHECK(nearest_name("kee", names) == "");
}

TEST_CASE("what is far from all names means none of them") {
  CHECK(nearest_name("threads", names) == "");
  CHECK(nearest_name("", names) == "");
  CHECK(nearest_name("size", {}) == "");
  CHECK(nearest_name(std::string(1'000'000, 's'), names) == "");
}

TEST_CASE("of names as near the first is meant") {
  const std::vector<std::string> both{"warp", "ward"};
  CHECK(nearest_name("war", both) == "warp");
  CHECK(nearest_name("ward", both) == "ward");
}

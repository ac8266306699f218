// What a surface reader says: a soup, or an error with a sentence.
#pragma once

#include <string>

#include "base/result.h"
#include "catch.h"
#include "surface/soup.h"

namespace lpq_test {

inline lpq::SurfaceSoup good(const lpq::Result<lpq::SurfaceSoup>& soup) {
  INFO((soup ? std::string() : soup.error().message));
  REQUIRE(soup.has_value());
  return soup.value();
}

inline lpq::Error bad(const lpq::Result<lpq::SurfaceSoup>& soup) {
  REQUIRE_FALSE(soup.has_value());
  CHECK_FALSE(soup.error().message.empty());
  return soup.error();
}

}  // namespace lpq_test

#include "base/few_warnings.h"

#include "catch.h"

using namespace lpq;

TEST_CASE("twenty warnings are kept, and the others counted") {
  const auto told = [](FewWarnings& few, int count) {
    for (int i = 0; i < count; ++i) few.add({ErrorCode::ignored, std::to_string(i), {}});
    return few.take();
  };
  FewWarnings few;
  CHECK(told(few, 0).empty());
  CHECK(told(few, 20).size() == 20);
  const std::vector<Warning> many = told(few, 23);
  REQUIRE(many.size() == 21);
  CHECK(many[19].message == "19");
  CHECK(many[20].code == ErrorCode::ignored);
  CHECK(many[20].message == "And 3 more of this kind.");
}

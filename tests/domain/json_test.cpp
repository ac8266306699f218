// The JSON reader: what it takes, and where it says the text is wrong.
#include <cmath>
#include <string>

#include "catch.h"
#include "io/domain/json_domain.h"

using namespace lpq;

namespace {

Result<DomainInput> parse(const std::string& text) {
  auto file = read_json_domain(text);
  if (!file) return file.error();
  return std::move(file->domain);
}

Error refused(const std::string& text) {
  const auto input = parse(text);
  REQUIRE_FALSE(input.has_value());
  INFO(input.error().message);
  CHECK(input.error().where.line >= 1);
  CHECK(input.error().where.byte >= 0);
  CHECK(input.error().where.byte <= static_cast<std::int64_t>(text.size()));
  return input.error();
}

bool mentions(const Error& error, const std::string& text) {
  UNSCOPED_INFO(error.message);
  return error.message.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("plain loops") {
  const auto input = parse(
      "\xEF\xBB\xBF{\"name\": \"x\", \"check\": {\"a\": [null, {\"b\": true}]}, \"h\": 0.5,\r\n"
      " \"loops\": [[[0, 0], [1e0, 0], [0.25, -1.5]]]}");
  REQUIRE(input.has_value());
  REQUIRE(input->regions.size() == 1);
  REQUIRE(input->regions[0].loops.size() == 1);
  CHECK(input->regions[0].loops[0] == Loop{{0, 0}, {1, 0}, {0.25, -1.5}});
  CHECK(input->h == 0.5);
}

TEST_CASE("tags beside the loops of one region are its tags") {
  for (const char* text : {R"({"loops": [[[0,0],[1,0],[1,1]]], "tags": [["in", "", "out"]]})",
                           R"({"tags": [["in", "", "out"]], "loops": [[[0,0],[1,0],[1,1]]]})"}) {
    const auto input = parse(text);
    REQUIRE(input.has_value());
    REQUIRE(input->regions.size() == 1);
    REQUIRE(input->regions[0].tags.size() == 1);
    CHECK(input->regions[0].tags[0] == std::vector<std::string>{"in", "", "out"});
  }
  CHECK(!parse(R"({"tags": [["a"]], "regions": [{"loops": [[[0,0],[1,0],[1,1]]]}]})"));
}

TEST_CASE("regions, tags, polylines and points") {
  const auto input = parse(R"({
    "regions": [{"name": "steel", "loops": [[[0,0],[1,0],[1,1]]], "tags": [["in", "", "out"]]},
                {"loops": [[[1,0],[2,0],[1,1]]]}],
    "polylines": [{"points": [[0.5,0.1],[0.6,0.2]], "tag": "crack"}],
    "points": [[0.7, 0.1], {"position": [0.8, 0.1], "tag": "probe"}]})");
  REQUIRE(input.has_value());
  REQUIRE(input->regions.size() == 2);
  CHECK(input->regions[0].name == "steel");
  CHECK(input->regions[0].tags[0] == std::vector<std::string>{"in", "", "out"});
  CHECK(input->polylines.at(0).tag == "crack");
  CHECK(input->polylines[0].points.size() == 2);
  REQUIRE(input->points.size() == 2);
  CHECK(input->points[0].position == Vec2{0.7, 0.1});
  CHECK(input->points[1].tag == "probe");

  const auto again = parse(write_domain_json(*input));
  REQUIRE(again.has_value());
  CHECK(again->regions[0].loops == input->regions[0].loops);
  CHECK(again->regions[0].tags == input->regions[0].tags);
  CHECK(again->regions[1].loops == input->regions[1].loops);
  CHECK(again->polylines[0].points == input->polylines[0].points);
  CHECK(again->points[1].tag == "probe");
}

TEST_CASE("sizes at points and guides") {
  const auto input = parse(R"({"guides": [[[0.1, 0.2], [0.3, 0.4]], [[1, 2], [3, 4], [5, 5]]],
    "sizes": [[0.5, 0.25, 0.01], [0, 0, 2]], "loops": [[[0,0],[1,0],[1,1]]]})");
  REQUIRE(input.has_value());
  CHECK(input->regions.at(0).loops.at(0).size() == 3);
  const auto again = parse(write_domain_json(*input));
  REQUIRE(again.has_value());
  for (const DomainInput& read : {*input, *again}) {
    using Guides = std::vector<DomainInput::Guide>;
    CHECK(read.guides == Guides{{{0.1, 0.2}, {0.3, 0.4}}, {{1, 2}, {3, 4}, {5, 5}}});
    REQUIRE(read.sizes.size() == 2);
    CHECK(read.sizes[0].position == Vec2{0.5, 0.25});
    CHECK(read.sizes[0].h == 0.01);
    CHECK(read.sizes[1].h == 2);
  }
  CHECK(mentions(refused(R"({"loops": [], "sizes": 0.1})"), "sizes should be an array"));
  CHECK(
      mentions(refused(R"({"loops": [], "sizes": [[1, 2]]})"), "sizes[0] should be a point with"));
  CHECK(mentions(refused(R"({"loops": [], "sizes": [[1, 2, 3, 4]]})"), "sizes[0][3]"));
  CHECK(mentions(refused(R"({"loops": [], "sizes": [[1, 2, "3"]]})"), "sizes[0][2]"));
  CHECK(mentions(refused(R"({"loops": [], "guides": [[1, 2]]})"), "guides[0][0]"));
  CHECK(mentions(refused(R"({"loops": [], "guides": [[[1, 2, 3]]]})"), "guides[0][0][2]"));
  CHECK(refused(R"({"loops": [], "guides": [[[1, NaN]]]})").code == ErrorCode::non_finite);
}

TEST_CASE("wrong kinds of value are named by their path") {
  CHECK(mentions(refused(R"({"loops": [[[0, 0], [1, null]]]})"), "loops[0][1][1]"));
  CHECK(mentions(refused(R"({"loops": [[[0, 0], [1, "2"]]]})"), "loops[0][1][1]"));
  CHECK(mentions(refused(R"({"loops": [[[0, 0], 7]]})"), "loops[0][1]"));
  CHECK(mentions(refused(R"({"loops": [[[0, 0], [1]]]})"), "loops[0][1]"));
  CHECK(mentions(refused(R"({"loops": [[[0, 0], [1, 2, 3]]]})"), "third coordinate"));
  CHECK(mentions(refused(R"({"regions": [{"name": 5}]})"), "regions[0].name"));
  CHECK(mentions(refused(R"({"loops": [], "points": [{"tag": "x"}]})"), "position"));
  CHECK(mentions(refused("[]"), "should be an object"));
  CHECK(mentions(refused("{}"), "neither"));
  CHECK(refused("{\n\n\"loops\": [[[0, 0], [1, null]]]}").where.line == 3);
}

TEST_CASE("points to start from") {
  const auto input =
      parse(R"({"seedPoints": [[0.5, 0.25], [-0, 2]], "loops": [[[0,0],[1,0],[1,1]]]})");
  REQUIRE(input.has_value());
  CHECK(input->regions.at(0).loops.at(0).size() == 3);
  const auto again = parse(write_domain_json(*input));
  REQUIRE(again.has_value());
  CHECK(input->seeds == std::vector<Vec2>{{0.5, 0.25}, {0, 2}});
  CHECK(again->seeds == input->seeds);
  CHECK(mentions(refused(R"({"loops": [], "seedPoints": 5})"), "seedPoints should be an array"));
  CHECK(mentions(refused(R"({"loops": [], "seedPoints": [1, 2]})"), "seedPoints[0] should be"));
  CHECK(mentions(refused(R"({"loops": [], "seedPoints": [[1]]})"), "seedPoints[0]"));
  CHECK(mentions(refused(R"({"loops": [], "seedPoints": [[1, 2, 3]]})"), "seedPoints[0][2]"));
  CHECK(refused(R"({"loops": [], "seedPoints": [[1, NaN]]})").code == ErrorCode::non_finite);
}

TEST_CASE("zeros keep their signs, however they are written") {
  const auto input =
      parse(R"({"loops": [[[-0, 0], [-0.0, 0.0], [-0e0, -1]]], "sizes": [[-0, 0, 1]]})");
  REQUIRE(input.has_value());
  const auto again = parse(write_domain_json(*input));
  REQUIRE(again.has_value());
  for (const DomainInput& read : {*input, *again}) {
    for (const Vec2 p : read.regions.at(0).loops.at(0)) CHECK(std::signbit(p.x));
    CHECK_FALSE(std::signbit(read.regions[0].loops[0][0].y));
    CHECK_FALSE(std::signbit(read.regions[0].loops[0][1].y));
    CHECK(read.regions[0].loops[0][2].y == -1);
    CHECK(std::signbit(read.sizes.at(0).position.x));
  }
}

TEST_CASE("numbers beyond double and NaN are not finite") {
  for (const std::string number : {"1e309", "-1e999", "NaN", "Infinity", "-Infinity"}) {
    const Error error = refused("{\"loops\": [[[0, 0], [" + number + ", 1]]]}");
    INFO(number << ": " << error.message);
    CHECK(error.code == ErrorCode::non_finite);
    CHECK(mentions(error, "loops[0][1][0]"));
  }
}

TEST_CASE("NaN and Infinity do no harm where they do not matter") {
  const auto input = parse(
      R"({"area": NaN, "note": "say \"NaN\"", "gap": [-Infinity, Infinity], "loops": [[[0, 0]]]})");
  REQUIRE(input.has_value());
  CHECK(input->regions[0].loops[0].size() == 1);
  CHECK(refused(R"({"regions": [{"name": NaN}]})").code == ErrorCode::parse_error);
}

TEST_CASE("a text cut anywhere, or with anything after it, is refused") {
  const std::string text =
      R"({"loops": [[[0, 0], [1, 0], [1, 1]]], "h": 0.1, "points": [{"position": [1, 2]}]})";
  REQUIRE(parse(text).has_value());
  for (std::size_t n = 0; n < text.size(); ++n)
    CHECK(refused(text.substr(0, n)).code == ErrorCode::parse_error);
  CHECK(refused(text + "x").code == ErrorCode::parse_error);
  CHECK(refused(text + text).code == ErrorCode::parse_error);
}

TEST_CASE("deep nesting and flipped bits end in a value or an error") {
  CHECK(refused("{\"a\": " + std::string(100000, '[')).code == ErrorCode::parse_error);
  const std::string text = R"({"regions": [{"loops": [[[0, 0], [1, 0]]], "tags": [["a"]]}]})";
  for (std::size_t i = 0; i < text.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = text;
      flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
      const auto input = parse(flipped);
      if (!input) CHECK(input.error().message.size() > 10);
    }
}

// JSON files: what is said about keys, tags and guides, and about text that is not UTF-8.
#include "catch.h"
#include "io/domain/json_domain.h"
#include "io/mesh/mesh_format.h"
#include "io/surface/surface_format.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const std::string square = "\"loops\": [[[0,0],[1,0],[1,1],[0,1]]]";

std::vector<Warning> warnings_of(const std::string& members) {
  return lpq_test::read_file("{" + members + "}", DomainFormat::json).warnings;
}
using TagTable = std::vector<std::vector<std::string>>;
TagTable tags_of(const std::string& members) {
  return lpq_test::read_file("{" + members + "}", DomainFormat::json).domain.regions[0].tags;
}
Error refused(const std::string& members) {
  const Error error = refusal("{" + members + "}", DomainFormat::json);
  CHECK(error.code == ErrorCode::parse_error);
  return error;
}

void check_warning(const std::string& members, const std::string& part) {
  const auto warnings = warnings_of(members);
  INFO(members);
  REQUIRE(warnings.size() == 1);
  INFO(warnings[0].message);
  CHECK(warnings[0].message.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("a key that is there twice is refused where it comes again") {
  const Error error = refused(square + ",\n" + square);
  CHECK(error.message == "loops is there twice; give it once.");
  CHECK(error.where.line == 2);
  CHECK(refused("\"h\": 1, \"h\": 2, " + square).message.find("h is there") == 0);
  CHECK(refused("\"regions\": [{\"name\": \"a\", \"name\": \"b\", " + square + "}]")
            .message.find("regions[0].name") == 0);
  CHECK(warnings_of("\"note\": 1, \"note\": 2, \"regions\": [{" + square + "}, {" + square + "}]")
            .empty());
}

TEST_CASE("a key that looks like one that is missing gets a word") {
  check_warning(square + ", \"guide\": []",
                "\"guide\" is not known and was ignored; did you mean "
                "\"guides\"?");
  check_warning("\n\"Points\": 5, " + square, "\"points\"");
  check_warning(square + ", \"size\": 0.1", "\"h\"");
  check_warning("\"regions\": [{\"nmae\": \"a\", " + square + "}]", "\"name\"");
  check_warning(square + ", \"points\": [{\"position\": [0.5, 0.5], \"tga\": \"x\"}]", "\"tag\"");
  CHECK(warnings_of("\n\"Points\": 5, " + square)[0].where.line == 2);
  // What files have beside the domain, and what only counts it, is nobody's slip.
  for (const char* key :
       {"name",   "source",     "licence", "license", "description", "valid", "why",
        "expect", "n_vertices", "n_loops", "check",   "attribution", "type",  "version",
        "title",  "author",     "comment", "id",      "x",           "unit",  "described",
        "",       "meta",       "crs",     "bbox"}) {
    INFO(key);
    CHECK(warnings_of("\"" + std::string(key) + "\": {\"guide\": {}}, " + square).empty());
  }
  std::string many = square;
  for (int i = 0; i < 5000; ++i) many += ", \"guide" + std::to_string(i % 10) + "\": 0";
  const std::vector<Warning> few = warnings_of(many);
  REQUIRE(few.size() == 21);
  CHECK(few.back().message == "And 980 more of this kind.");
}

TEST_CASE("tags and guides that do not fit are the file's fault") {
  const auto tags = [](const std::string& list) { return square + ", \"tags\": " + list; };
  CHECK(warnings_of(tags("[[\"a\", \"b\", \"c\", \"d\"]]")).empty());
  CHECK(warnings_of(tags("[[]]")).empty());
  check_warning(tags("[[\"a\", \"b\", \"c\"]]"), "has 4 edges but only 3 edge tags");
  CHECK(tags_of(tags("[[\"a\", \"b\"]]")) == TagTable{{"a", "b", "", ""}});
  CHECK(tags_of(tags("[[], []]")) == TagTable{{}});
  CHECK(refused(tags("[[\"a\", \"b\", \"c\", \"d\", \"e\"]]")).where.loop == 0);
  CHECK(refused(tags("[[], [\"a\"]]")).where.loop == 1);
  // The first point once more at the end makes no edge.
  CHECK(warnings_of("\"loops\": [[[0,0],[1,0],[1,1],[0,0]]], \"tags\": [[\"a\",\"b\",\"c\"]]")
            .empty());
  CHECK(refused(square + ", \"guides\": [[[0,0],[1,1]], [[0.5,0.5]]]").where.guide == 1);
  CHECK(refused(square + ", \"guides\": [[]]").where.guide == 0);
  CHECK(refused(square + ", \"guides\": [[[0.5,0.5],[0.5,0.5]]]").where.guide == 0);
}

TEST_CASE("UTF-16 is called by its name, in every format") {
  const auto wide = [](const std::string& text, bool little, bool mark) {
    std::string bytes = mark ? (little ? "\xFF\xFE" : "\xFE\xFF") : "";
    for (const char c : text) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
  };
  const auto check_named = [](const Error& error) {
    CHECK(error.code == ErrorCode::parse_error);
    CHECK(error.message == "This file is UTF-16 text; save it as UTF-8.");
    CHECK(error.where.line == 1);
  };
  for (const bool little : {true, false}) {
    for (const bool mark : {true, false}) {
      for (const auto& [format, text] : sample_domain_files()) {
        check_named(refusal(wide(text, little, mark), format));
        check_named(read_domain_file("", wide(text, little, mark)).error());
      }
      check_named(read_mesh(wide("v 0 0 0", little, mark), MeshFormat::obj).error());
      check_named(read_surface(wide("OFF", little, mark), SurfaceFormat::off).error());
    }
  }
}

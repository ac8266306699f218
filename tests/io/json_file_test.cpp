// JSON files: what is said about keys, tags and guides, and about text that is not UTF-8.
#include "catch.h"
#include "io/domain/json_domain.h"
#include "io/mesh/mesh_format.h"
#include "io/surface/surface_format.h"
#include "support/domain_data.h"
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

TEST_CASE("a key that holds points or a size gets a word, and notes do not") {
  check_warning(square + ", \"holes\": [[[0.2,0.2],[0.4,0.2],[0.4,0.4]]]",
                "\"holes\" is not known and was ignored; holes are further loops of \"loops\".");
  check_warning("\"regions\": [{" + square + ", \"Hole\": [[[0.2,0.2]]]}]", "further loops");
  for (const char* key : {"outer", "boundary", "vertices", "elements", "edges", "nodes", "x"}) {
    INFO(key);
    for (const char* value : {"[[0,0],[1,0]]", "[0,0,1,0,1,1]", "[{\"x\": 0}]", "{\"a\": [[0,1]]}"})
      check_warning(square + ", \"" + key + "\": " + value,
                    "\"" + std::string(key) + "\" is not known and was ignored.");
    for (const char* value : {"[]", "[\"a\", \"b\"]", "[0,0,1,1]", "{\"a\": [0,0,1,0,1,1,0,1]}",
                              "5", "true", "null", "\"a\"", "{\"a\": 1, \"b\": {}}"}) {
      INFO(value);
      CHECK(warnings_of(square + ", \"" + key + "\": " + value).empty());
    }
  }
  check_warning(square + ", \"H\": 0.5", "did you mean \"h\"?");
  for (const char* key : {"hmax", "mesh_size", "lc", "size"})
    check_warning(square + ", \"h\": 1, \"" + key + "\": 0.5", "the size of the mesh is \"h\".");
  for (const char* key : {"h", "size", "H"})
    check_warning("\"regions\": [{" + square + ", \"" + key + "\": 0.1}]",
                  "\"sizes\" of the document");
  check_warning(square + ", \"points\": [{\"position\": [0.5,0.5], \"h\": 0.1}]", "\"sizes\" of");
  check_warning(square + ", \"points\": [], \"Points\": [[0.5,0.5]]",
                "\"Points\" is not known and was ignored.");
  CHECK(warnings_of("\n\"holes\":\n[\n[[0,0]]], " + square)[0].where.line == 2);
  for (const char* key :
       {"meta", "metadata", "properties", "comments", "_mesh", "$defs", "warnings"}) {
    INFO(key);
    CHECK(warnings_of(square + ", \"" + key + "\": {\"a\": [[0,0],[1,1]], \"h\": [{}]}").empty());
    CHECK(warnings_of(square + ", \"" + key + "\": [{\"where\": {\"x\": 1}}]").empty());
  }
  // Many notes do not hide what the document has.
  std::string points = square + ", \"points\": [";
  for (int i = 0; i < 2000; ++i)
    points += (i == 0 ? "" : ",") + std::string("{\"position\": [0.5,0.5], \"id\": 1}");
  check_warning(points + "], \"holes\": [[[0,0]]]", "\"holes\"");
  const std::string endless(100000, 'k');
  CHECK(warnings_of(square + ", \"" + endless + "\": [[0,0]]")[0].message.size() < 200);
}

TEST_CASE("no domain at hand has a key that gets a word") {
  for (const char* folder : {"polygons", "invalid", "../domains"}) {
    for (const auto& path : shared_domains(folder)) {
      const auto file = read_domain_file(path.string(), read_text(path));
      if (!file) continue;
      for (const Warning& warning : file->warnings) {
        INFO(path << " " << warning.message);
        CHECK(warning.message.find("not known") == std::string::npos);
      }
    }
  }
}

TEST_CASE("tags and guides that do not fit are the file's fault") {
  const auto tags = [](const std::string& list) { return square + ", \"tags\": " + list; };
  CHECK(warnings_of(tags("[[\"a\", \"b\", \"c\", \"d\"]]")).empty());
  CHECK(warnings_of(tags("[[]]")).empty());
  check_warning(tags("[[\"a\", \"b\", \"c\"]]"), "has 4 edges but only 3 edge tags");
  CHECK(tags_of(tags("[[\"a\", \"b\"]]")) == TagTable{{"a", "b", "", ""}});
  CHECK(tags_of(tags("[[], []]")) == TagTable{{}});
  CHECK(refused(tags("[[\"a\", \"b\", \"c\", \"d\", \"e\"]]")).where.loop == 0);
  const Error beyond = refused(tags("[[], [\"a\"]]"));
  CHECK(beyond.where.loop == 1);
  CHECK(beyond.message.find("for 2 loops, but only 1; give a list of tags per loop") !=
        std::string::npos);
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

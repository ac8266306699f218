#include "io/escape.h"

#include <set>

#include "catch.h"
#include "io/json_write.h"
#include "io/unique_names.h"

using namespace lpq;

namespace {

template <class Append>
std::string escaped(Append append, std::string_view text) {
  std::string out;
  append(out, text);
  return out;
}

}  // namespace

TEST_CASE("XML text has no markup and no forbidden character") {
  CHECK(escaped(append_xml, "<b a=\"1\" c='2'>&") ==
        "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
  CHECK(escaped(append_xml, std::string_view("a\0b\x01\n", 5)) == "a?b? ");
  CHECK(escaped(append_xml,
                "Stra\xC3\x9F"
                "e") ==
        "Stra\xC3\x9F"
        "e");
}

TEST_CASE("broken UTF-8 never reaches a file") {
  for (const char* text : {"\x80", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80",
                           "\xF5\x80\x80\x80", "\xF4\x90\x80\x80", "\xFF"}) {
    INFO(text);
    CHECK(escaped(append_xml, text).find_first_not_of('?') == std::string::npos);
    CHECK(escaped(append_json_string, text).find('\\') == std::string::npos);
    CHECK(escaped(append_json_string, text).find("\xEF\xBF\xBD") == 1);
  }
  CHECK(escaped(append_xml, "\xF0\x9F\x98\x80") == "\xF0\x9F\x98\x80");
}

TEST_CASE("JSON strings escape quotes, backslashes and controls") {
  CHECK(escaped(append_json_string, "a\"b\\c\n\x02") == "\"a\\\"b\\\\c\\n\\u0002\"");
}

TEST_CASE("MSH names have no quote, no line break and at most 127 bytes") {
  CHECK(escaped(append_msh_name, "a\"b\nc") == "a'b c");
  std::string name;
  for (int i = 0; i < 100; ++i) name += "\xC3\xA9";
  const std::string cut = escaped(append_msh_name, name);
  CHECK(cut.size() == 126);  // whole characters of two bytes
  CHECK(cut == name.substr(0, 126));
}

TEST_CASE("MSH names have no backslash, which shlex would take for an escape") {
  CHECK(escaped(append_msh_name, "C:\\a\\") == "C:/a/");
}

TEST_CASE("an OBJ name is one word that is no comment") {
  CHECK(escaped(append_obj_name, "#1 a#2\tb\\") == "_1_a#2_b_");
  CHECK(escaped(append_obj_name, "##") == "_#");
}

TEST_CASE("names stay different as a format writes them") {
  const std::vector<std::string> names{"a b", "a_b", "a_b_2", "#1", "_1", "a\tb"};
  CHECK(unique_names(names, append_obj_name) ==
        std::vector<std::string>{"a_b", "a_b_2", "a_b_2_2", "_1", "_1_2", "a_b_3"});
  const std::string umlauts = [] {
    std::string text;
    for (int i = 0; i < 64; ++i) text += "\xC3\xBC";
    return text;
  }();
  const std::vector<std::string> same_start{umlauts + "1", umlauts + "2", umlauts + "3"};
  const auto written = unique_names(same_start, append_msh_name, longest_msh_name);
  CHECK(std::set<std::string>(written.begin(), written.end()).size() == 3);
  for (const std::string& name : written) {
    CHECK(name.size() <= longest_msh_name);
    CHECK(escaped(append_msh_name, name) == name);  // no character is cut
  }
}

TEST_CASE("ASCII text is one printable line") {
  std::string out;
  append_ascii(out, "a\n\xC3\xA9\xFF\x7F|");
  CHECK(out == "a ?? |");
  out.clear();
  append_quoted_ascii(out, "say \"x\" \xE9\x8B\xBC", 9);
  CHECK(out == "\"say 'x' ?\"");
}

TEST_CASE("the JSON writer puts commas where they belong") {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.member("a", 1);
  json.new_line();
  json.key("b");
  json.begin_array();
  json.tuple(1, 2.5);
  json.begin_object();
  json.end_object();
  json.null();
  json.end_array();
  json.member("c", true);
  json.member("d", 0.0 / 1.0 - 1e308 * 10);
  json.end_object();
  CHECK(out == "{\"a\":1,\n\"b\":[[1,2.5],{},null],\"c\":true,\"d\":null}");
}

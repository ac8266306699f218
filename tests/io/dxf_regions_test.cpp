// DXF: which regions drawings on several layers make, and how these are named.
#include <map>

#include "catch.h"
#include "io/domain/dxf_domain.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainFile read_dxf(const std::string& entities) {
  const auto size = entities.find_last_not_of(' ') + 1;
  return lpq_test::read_file(dxf(entities.substr(0, size)), DomainFormat::dxf);
}
double area(const std::string& entities) { return total_area(read_dxf(entities).domain); }

std::string rectangle(const std::string& layer, double x, double y, double width, double height) {
  const auto corner = [](double at_x, double at_y) {
    return "10 " + std::to_string(at_x) + " 20 " + std::to_string(at_y) + " ";
  };
  return "0 LWPOLYLINE 8 " + layer + " 70 1 " + corner(x, y) + corner(x + width, y) +
         corner(x + width, y + height) + corner(x, y + height);
}

}  // namespace

TEST_CASE("closed outlines side by side keep their names, and divided ones pass theirs on") {
  const auto names_by_place = [](const DomainFile& file) {
    std::map<double, std::string> names;  // by the least x of each region
    for (const auto& region : file.domain.regions) {
      double least = region.loops[0][0].x;
      for (const Vec2 p : region.loops[0]) least = std::min(least, p.x);
      names[least] += region.name;
    }
    return names;
  };
  using Names = std::map<double, std::string>;
  const auto row = read_dxf(rectangle("steel", 0, 0, 4, 4) + rectangle("air", 4, 0, 4, 4) +
                            rectangle("0", 8, 0, 4, 4) + rectangle("copper", 12, 0, 4, 4));
  CHECK(names_by_place(row) == Names{{0, "steel"}, {4, "air"}, {8, ""}, {12, "copper"}});
  CHECK(make_domain(row.domain).has_value());
  const auto divided =
      read_dxf(rectangle("steel", 0, 0, 4, 4) + "0 LINE 8 rib 10 2 20 0 11 2 21 4 ");
  CHECK(names_by_place(divided) == Names{{0, "steel"}, {2, "steel"}});
  // Lines of one layer along a border of another one.
  const auto lined = read_dxf(rectangle("steel", 0, 0, 4, 4) +
                              "0 LINE 8 air 10 4 20 0 11 8 21 0 0 LINE 8 air 10 8 20 0 11 8 21 4 "
                              "0 LINE 8 air 10 8 20 4 11 4 21 4 0 LINE 8 air 10 4 20 4 11 4 21 0 ");
  CHECK(names_by_place(lined) == Names{{0, "steel"}, {4, "air"}});
}

TEST_CASE("closed outlines side by side may share a part of an edge") {
  const std::string a = rectangle("a", 0, 0, 10, 10);
  for (const std::string& b :
       {rectangle("b", 10, 2, 10, 6), rectangle("b", 10, -3, 10, 20), rectangle("b", 10, 5, 10, 10),
        rectangle("b", 10, 0, 10, 4), rectangle("b", -5, 10, 20, 1)})
    for (const std::string& entities : {a + b, b + a}) {
      INFO(entities);
      const auto file = read_dxf(entities);
      REQUIRE(file.domain.regions.size() == 2);
      CHECK(file.domain.regions[0].name != file.domain.regions[1].name);
      CHECK(make_domain(file.domain).has_value());
      CHECK(total_area(file.domain) == area(a) + area(b));
    }
  // Turned, with six digits: beside the edge by rounding.
  const auto turned = read_dxf(
      "0 LWPOLYLINE 70 1 10 0 20 0 10 9.55336 20 2.9552 10 6.59816 20 12.5086 10 -2.9552 20 "
      "9.55336 "
      "0 LWPOLYLINE 70 1 10 8.96232 20 4.86588 10 18.5157 20 7.82108 10 16.7426 20 13.5531 "
      "10 7.1892 20 10.5979");
  CHECK(turned.domain.regions.size() == 2);
  CHECK(make_domain(turned.domain).has_value());
  // One that overlaps another one, or lies in it along its border, is for the door to judge.
  for (const std::string& b : {rectangle("b", 5, 0, 10, 10), rectangle("b", 7, 2, 3, 3)})
    CHECK_FALSE(make_domain(read_dxf(a + b).domain).has_value());
}

TEST_CASE("what exactly fills a hole is material with its name, a hole drawn twice stays one") {
  const std::string plate = rectangle("steel", 0, 0, 10, 10);
  const std::string hole = rectangle("steel", 3, 3, 3, 3), core = rectangle("copper", 3, 3, 3, 3);
  for (const std::string& both : {hole + core, core + hole}) {
    const auto file = read_dxf(plate + both + rectangle("slot", 4, 4, 1, 1));
    CHECK(total_area(file.domain) == 99);  // what lies in the core is a hole in it
    REQUIRE(file.domain.regions.size() == 2);
    CHECK(file.domain.regions[0].name == "steel");
    CHECK(file.domain.regions[1].name == "copper");
    CHECK(make_domain(file.domain).has_value());
  }
  CHECK(area(plate + hole + hole) == 91);
  CHECK(area(plate + plate) == 100);
  CHECK(area(plate + rectangle("copper", 0, 0, 10, 10)) == 100);
  CHECK(area(plate + rectangle("copper", 0, 0, 10, 10) + hole) == 91);
  // In two halves, or in one half alone.
  const std::string half = rectangle("left", 3, 3, 1.5, 3);
  const std::string divided =
      "0 LWPOLYLINE 8 steel 70 1 10 3 20 3 10 4.5 20 3 10 6 20 3 10 6 20 6 10 4.5 20 6 10 3 20 6 ";
  const auto halves = read_dxf(plate + divided + half + rectangle("right", 4.5, 3, 1.5, 3));
  CHECK(total_area(halves.domain) == 100);
  CHECK(halves.domain.regions.size() == 3);
  CHECK(area(plate + divided + half) == 95.5);
}

TEST_CASE("a circle is the same one however it was drawn") {
  const std::string circle = "0 CIRCLE 8 A 10 0 20 0 40 5 ";
  const double once = area(circle);
  for (const char* again : {"0 LWPOLYLINE 8 A 70 1 10 5 20 0 42 1 10 -5 20 0 42 1",
                            "0 ARC 8 A 10 0 20 0 40 5 50 0 51 "
                            "90 0 ARC 8 A 10 0 20 0 40 5 50 90 51 360",
                            "0 ELLIPSE 8 A 10 0 20 0 11 5 21 0 40 1"}) {
    INFO(again);
    const auto file = read_dxf(circle + again);
    CHECK(file.domain.regions.size() == 1);
    CHECK(std::abs(total_area(file.domain) - once) < 0.01);
    CHECK(make_domain(file.domain).has_value());
    REQUIRE(file.warnings.size() == 1);
    CHECK(file.warnings[0].code == ErrorCode::overlapping_edges);
  }
  // A shape of a billionth of the size is not lost for it.
  CHECK(read_dxf(rectangle("0", 0, 0, 1e6, 1e6) + rectangle("0", 2e6, 0, 1e-3, 1e-3))
            .domain.regions.size() == 2);
}

TEST_CASE("layers are named in the letters of the drawing") {
  const auto read = [](const std::string& layer, const std::string& code_page) {
    std::string text = dxf("0 CIRCLE 8 " + layer + " 10 0 20 0 40 1");
    if (!code_page.empty())
      text = "0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\n" + code_page + "\n0\nENDSEC\n" + text;
    return lpq_test::read_file(text, DomainFormat::dxf);
  };
  const auto name = [&](const std::string& layer, const std::string& code_page = "ANSI_1252") {
    const auto file = read(layer, code_page);
    CHECK(file.warnings.empty());
    return file.domain.regions[0].name;
  };
  CHECK(name("A\\U+00C4B", "") ==
        "A\xC3\x84"
        "B");
  CHECK(name("\\U+D83D\\U+DE00") == "\xF0\x9F\x98\x80");
  CHECK(name("\\U+00C\\U+") == "\\U+00C\\U+");
  CHECK(name("\\U+DE00") == "\xEF\xBF\xBD");
  CHECK(name("\xC4\x80") == "\xC4\x80");  // UTF-8 whatever the header says
  CHECK(name("\xC4") == "\xC3\x84");
  CHECK(name("\xC4", "iso8859-1") == "\xC3\x84");
  CHECK(name("\x80\x99") == "\xE2\x82\xAC\xE2\x84\xA2");
  const auto guessed = read("\xD6", "");
  CHECK(guessed.domain.regions[0].name == "\xC3\x96");
  CHECK(guessed.warnings.size() == 1);
  const auto unknown = read("a\xD6", "ANSI_932");
  CHECK(unknown.domain.regions[0].name == "a?");
  REQUIRE(unknown.warnings.size() == 1);
  CHECK(unknown.warnings[0].message.find("\"ANSI_932\"") != std::string::npos);
}

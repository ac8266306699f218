// SVG: transforms, what counts as an outline, what hides or fills it.
#include "io/domain/svg_domain.h"

#include <array>

#include "base/rng.h"
#include "catch.h"
#include "io/domain/svg_path.h"
#include "numerics/elementary.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainFile read_svg(const std::string& content) {
  return lpq_test::read_file(svg(content), DomainFormat::svg);
}

}  // namespace

TEST_CASE("shapes have their areas") {
  const auto area = [](const std::string& content) { return total_area(read_svg(content).domain); };
  CHECK(area("<rect x='1' y='2' width='3' height='4'/>") == 12);
  CHECK(area("<polygon points='0,0 4,0 4,3'/>") == 6);
  CHECK(area("<polyline points='0 0 4 0 4 3'/>") == 6);  // filled, so closed
  // A chord of a circle strays by 2e-4 of its diameter at most: two thirds of that on average.
  const double circle = area("<circle cx='5' r='1'/>");
  CHECK(circle < pi);
  CHECK(circle > pi - 2 * pi * 4e-4);
  const double ellipse = area("<ellipse rx='3' ry='1'/>");
  CHECK(ellipse < 3 * pi);
  CHECK(ellipse > 3 * pi - 14 * 12e-4);
  const double rounded = area("<rect width='4' height='3' rx='1'/>");
  CHECK(rounded < 12 - (4 - pi));
  CHECK(rounded > 12 - (4 - pi) - 2 * pi * 8e-4);
  CHECK(area("<rect width='4' height='3' ry='9' rx='1'/>") ==
        area("<rect width='4' height='3' rx='1' ry='1.5'/>"));
  CHECK(area("<rect width='1in' height='96px'/>") == 96 * 96);
  std::vector<Subpath> subpaths;
  REQUIRE_FALSE(read_path_data("M0 0C0 1 1 1 1 0Z", subpaths));
  Loop bezier;
  subpaths[0].curve.flatten(1e-6, bezier);
  CHECK(std::abs(std::abs(signed_area(bezier)) - 0.6) < 1e-6);
}

TEST_CASE("y points up, and transforms apply from the inside out") {
  const auto first = [](const std::string& content) {
    return read_svg(content).domain.regions.at(0).loops.at(0).at(0);
  };
  const std::string shape = "<path d='M2 1h3v4z'";
  CHECK(first(shape + "/>") == Vec2{2, -1});
  CHECK(first(shape + " transform='translate(10)'/>") == Vec2{12, -1});
  CHECK(first(shape + " transform='translate(10,20)'/>") == Vec2{12, -21});
  CHECK(first(shape + " transform='scale(2)'/>") == Vec2{4, -2});
  CHECK(first(shape + " transform='scale(2 -3)'/>") == Vec2{4, 3});
  CHECK(first(shape + " transform='rotate(90)'/>") == Vec2{-1, -2});
  CHECK(first(shape + " transform='rotate(-180 2 2)'/>") == Vec2{2, -3});
  CHECK(first(shape + " transform='matrix(1 2 3 4 5 6)'/>") == Vec2{10, -14});
  CHECK(distance(first(shape + " transform='skewX(45)'/>"), {3, -1}) < 1e-15);
  CHECK(distance(first(shape + " transform='skewY(45)'/>"), {2, -3}) < 1e-15);
  CHECK(first(shape + " transform='translate(1 0) , scale(2)'/>") == Vec2{5, -2});
  CHECK(first("<g transform='scale(2)'><svg:g transform='translate(1,0)'>" + shape +
              "/></svg:g></g>") == Vec2{6, -2});
  for (const char* bad :
       {"rotate(1 2)", "scale()", "matrix(1 2 3)", "turn(3)", "scale(2", "skewX(90)"})
    CHECK(refusal(svg(shape + " transform='" + bad + "'/>"), DomainFormat::svg).code ==
          ErrorCode::parse_error);
}

TEST_CASE("outlines nest by the even-odd rule over all elements") {
  const auto file = read_svg(
      "<circle id='island' cx='3' cy='3' r='.5'/><path id='plate' d='M0 0h10v10h-10z M1 "
      "1v4h4v-4z'/>"
      "<rect id='hole' x='6' y='6' width='2' height='2'/><rect x='20' width='1' height='1'/>");
  REQUIRE(file.domain.regions.size() == 3);
  CHECK(file.warnings.empty());
  CHECK(file.domain.regions[0].name == "island");
  CHECK(file.domain.regions[1].name == "plate");
  CHECK(file.domain.regions[1].loops.size() == 3);
  CHECK(region_area(file.domain.regions[1]) == 100 - 16 - 4);
  CHECK(file.domain.regions[2].name.empty());
  const auto tags = file.domain.regions[1].tags;
  REQUIRE(tags.size() == 3);
  CHECK(tags[2] == std::vector<std::string>(4, "hole"));
}

TEST_CASE("what fills a hole of a path, or lies beside a shape, has its own name") {
  const std::string path = "<path id='steel' d='M0 0h10v6h-10z M2 2h3v2h-3z'/>";
  const std::string core = "<rect id='copper' x='2' y='2' width='3' height='2'/>";
  for (const std::string& both : {path + core, core + path}) {
    const auto file = read_svg(both);
    CHECK(total_area(file.domain) == 60);
    REQUIRE(file.domain.regions.size() == 2);
    for (const auto& region : file.domain.regions)
      CHECK(region.name == (region.loops.size() == 2 ? "steel" : "copper"));
  }
  const auto row = read_svg(
      "<rect id='a' width='5' height='6'/><rect id='b' x='5' width='5' height='6'/>"
      "<rect id='c' x='10' width='5' height='6'/>");
  std::string names;
  for (const auto& region : row.domain.regions) names += region.name;
  std::sort(names.begin(), names.end());
  CHECK(names == "abc");
}

TEST_CASE("what crosses is painted by its rule, and taken as one") {
  const std::string star = "d='M0 -10L5.878 8.09-9.511-3.09 9.511-3.09-5.878 8.09z'";
  const auto whole = read_svg("<path " + star + "/>");
  REQUIRE(whole.domain.regions.size() == 1);
  CHECK(whole.domain.regions[0].loops[0].size() == 10);
  REQUIRE(whole.warnings.size() == 1);
  CHECK(whole.warnings[0].code == ErrorCode::adapted);
  for (const char* rule : {"fill-rule='evenodd'", "style='fill-rule:evenodd'"}) {
    const auto tips = read_svg("<g " + std::string(rule) + "><path id='star' " + star + "/></g>");
    REQUIRE(tips.domain.regions.size() == 5);
    CHECK(tips.domain.regions[0].loops[0].size() == 3);
    CHECK(tips.domain.regions[0].name == "star");
  }
  // Elements paint over each other, whatever their rules; what does not cross nests as ever.
  const std::string two =
      "<g fill-rule='evenodd'><rect id='a' width='4' height='4'/><rect id='b' x='2' y='2' "
      "width='4' height='4'/></g>";
  const auto holed = read_svg(two + "<rect x='2.5' y='2.5' width='1' height='1'/>");
  REQUIRE(holed.domain.regions.size() == 1);
  CHECK(region_area(holed.domain.regions[0]) == 16 + 16 - 4 - 1);
  CHECK(holed.domain.regions[0].loops.size() == 2);
  const auto hole = read_svg(two + "<rect x='-1' y='-1' width='9' height='9'/>");
  REQUIRE(hole.domain.regions.size() == 1);
  CHECK(region_area(hole.domain.regions[0]) == 81 - (16 + 16 - 4));
  // Not painted: not taken as one.
  const auto drawn = read_svg("<g fill='none'>" + two.substr(two.find("<rect")));
  CHECK(drawn.warnings.empty());
  CHECK_FALSE(make_domain(drawn.domain).has_value());
  // Too far away to be measured: left to the door.
  const auto far = read_svg("<rect width='1e200' height='1e200'/><path d='M-1e200 1h3e200v1z'/>");
  CHECK(far.warnings.empty());
  // Outlines beside each other by rounding leave no gap and no sliver.
  const auto beside = read_svg(
      "<rect width='4' height='4'/><path d='M2 4.0000000001 3 3.9999999999 4 4v2h-2z'/>"
      "<path d='M4 1h3v2h-3.0000000001z'/>");
  REQUIRE(beside.domain.regions.size() == 1);
  CHECK(beside.domain.regions[0].loops.size() == 1);
  for (std::size_t i = 1; i < beside.domain.regions[0].loops[0].size(); ++i)
    CHECK(distance(beside.domain.regions[0].loops[0][i - 1], beside.domain.regions[0].loops[0][i]) >
          0.5);
}

TEST_CASE("what crosses the border of a hole lies in the paint around the hole") {
  const auto area = [](const std::string& content) { return total_area(read_svg(content).domain); };
  const std::string holed = "<path fill-rule='evenodd' d='M0 0H100V60H0Z M20 20H50V40H20Z'/>";
  const std::string turned = "<path d='M0 0H100V60H0Z M20 20V40H50V20Z'/>";
  for (const std::string& plate : {holed, turned}) {
    CHECK(area(plate + "<rect x='40' y='25' width='40' height='10'/>") == 5400 + 100);
    CHECK(area("<rect x='10' y='25' width='50' height='10'/>" + plate) == 5400 + 300);
    CHECK(area(plate + "<rect x='40' y='25' width='80' height='10'/>") == 5400 + 100 + 200);
    CHECK(area(plate + "<rect x='-9' y='-9' width='10' height='10'/>") == 5400 + 99);
    // What meets nothing of these nests as ever, in the material and in the hole.
    const std::string bar = plate + "<rect x='40' y='25' width='40' height='10'/>";
    CHECK(area(bar + "<rect x='85' y='5' width='10' height='10'/>") == 5500 - 100);
    CHECK(area(bar + "<rect x='25' y='25' width='10' height='10'/>") == 5500 + 100);
    // So do others that cross.
    CHECK(area(bar + "<rect x='85' y='5' width='10' height='10'/>"
                     "<rect x='90' y='10' width='5' height='10'/>") == 5500 - 125);
  }
  // One element by its rule: where the hole and the bar overlap, it winds once.
  CHECK(area("<path d='M0 0H100V60H0Z M20 20V40H50V20Z M40 10V50H60V10Z'/>") ==
        6000 - 600 - 800 + 2 * 200);
  const double filled = area(
      "<path fill-rule='evenodd' d='M0 0H100V60H0Z M60 30A10 10 0 1 0 40 30A10 10 0 1 0 60 30Z'/>"
      "<circle cx='50' cy='30' r='10'/>");
  CHECK(std::abs(filled - 6000) < 1);
}

TEST_CASE("a neighbour of what crosses stays") {
  for (const char* neighbour : {"<rect x='-10' width='10' height='10'/>",
                                "<path d='M0 0H-10V10H0Z'/>", "<path d='M0 10V0H-10V10Z'/>"}) {
    const std::string two =
        "<rect width='10' height='10'/><rect x='5' y='5' width='10' "
        "height='10'/>";
    CHECK(total_area(read_svg(two + neighbour).domain) == 275);
    CHECK(total_area(read_svg(neighbour + two).domain) == 275);
  }
}

namespace {

constexpr int bar_cells = 12;

/// Bars along the axes from end to end of the cells, as one path.
struct Bars {
  std::string path;
  std::array<std::array<int, bar_cells>, bar_cells> winding{};

  void add(Rng& rng, bool upright) {
    const int from = static_cast<int>(rng.below(bar_cells - 3));
    const int to = from + 1 + static_cast<int>(rng.below(3));
    std::array<std::array<int, 2>, 4> corners{
        {{0, from}, {bar_cells, from}, {bar_cells, to}, {0, to}}};
    const bool back = rng.below(2) == 1;
    if (back) std::swap(corners[1], corners[3]);
    char command = 'M';
    for (const auto& [along, across] : corners) {
      path += command + std::to_string(upright ? across : along) + " " +
              std::to_string(upright ? along : across);
      command = 'L';
    }
    path += 'z';
    for (int i = 0; i < bar_cells; ++i)
      for (int j = from; j < to; ++j)
        (upright ? winding[j][i] : winding[i][j]) += back == upright ? 1 : -1;
  }
};

}  // namespace

TEST_CASE("bars that cross have the area of the cells they paint") {
  Rng rng(11);
  for (int round = 0; round < 60; ++round) {
    const bool even_odd = round % 2 == 1;
    std::string elements;
    std::array<std::array<bool, bar_cells>, bar_cells> painted{};
    for (int element = 0; element < 3; ++element) {
      Bars bars;
      for (const bool upright : {true, true, false}) bars.add(rng, upright);
      elements += std::string("<path fill-rule='") + (even_odd ? "evenodd" : "nonzero") + "' d='" +
                  bars.path + "'/>";
      for (int i = 0; i < bar_cells; ++i)
        for (int j = 0; j < bar_cells; ++j)
          if (even_odd ? bars.winding[i][j] % 2 != 0 : bars.winding[i][j] != 0)
            painted[i][j] = true;
    }
    INFO(elements);
    int count = 0;
    for (const auto& column : painted)
      for (const bool cell : column) count += cell;
    CHECK(total_area(read_svg(elements).domain) == count);
  }
}

TEST_CASE("what is not drawn, not filled or not closed") {
  const std::string plate = "<rect width='9' height='9'/>";
  CHECK(read_svg(plate + "<defs><circle r='1'/></defs><g display='none'><circle r='1'/></g>"
                         "<clipPath><circle r='1'/></clipPath><symbol><circle r='1'/></symbol>"
                         "<circle r='1' style='stroke:red; display : none !important'/>")
            .domain.regions[0]
            .loops.size() == 1);
  const auto used = read_svg(plate + "<use href='#a'/><text>x</text><use/>");
  REQUIRE(used.warnings.size() == 1);
  CHECK(used.warnings[0].message == "Left out: 2 use without its element and 1 text.");
  // Open and not filled: a polyline inside; where ends meet, an outline.
  const auto crack =
      read_svg(plate +
               "<path id='crack' fill='none' d='M1 1L2 2 3 1'/>"
               "<g fill='none'><path d='M20 0h1'/></g><line x1='1' y1='5' x2='2' y2='5'/>");
  REQUIRE(crack.domain.polylines.size() == 2);
  CHECK(crack.domain.polylines[0].tag == "crack");
  CHECK(crack.domain.polylines[0].points.size() == 3);
  CHECK(crack.warnings.size() == 1);  // of the one outside
  const auto pieces =
      read_svg(plate + "<g style='fill:none'><path d='M1 1h2v2'/><path d='M1 1v2h2'/></g>");
  CHECK(region_area(pieces.domain.regions[0]) == 81 - 4);
  // Open and filled: closed, with a warning.
  const auto closed = read_svg(plate + "<path d='M1 1h2v2'/>");
  CHECK(region_area(closed.domain.regions[0]) == 81 - 2);
  CHECK(closed.warnings.size() == 1);
}

TEST_CASE("relative commands that come back but for rounding close without an edge") {
  // 0.1 + 0.2 - 0.3 is not 0 in doubles.
  const auto file = read_svg("<path d='M17.5 6.1l.1 2h.2l-.3-2zM0 0v9h20v-9z'/>");
  REQUIRE(file.domain.regions.size() == 1);
  REQUIRE(file.domain.regions[0].loops.size() == 2);
  CHECK(file.domain.regions[0].loops[0].size() + file.domain.regions[0].loops[1].size() == 7);
  CHECK(file.warnings.empty());
}

TEST_CASE("curves that miss their start by the digits of their numbers close there") {
  const auto disk = read_svg("<path d='M8 2c3 0 6 3 6 6s-3 6-6 6-6-3-6-6 3-6 6.001-6z'/>");
  CHECK(disk.warnings.empty());
  REQUIRE(disk.domain.regions.size() == 1);
  const auto& loop = disk.domain.regions[0].loops[0];
  for (std::size_t i = 1; i < loop.size(); ++i) CHECK(distance(loop[i - 1], loop[i]) > 0.01);
  CHECK(distance(loop.front(), loop.back()) > 0.01);
  // Lines of that length are meant.
  CHECK(read_svg("<path d='M0 0h9v9h-9v-8.999l-.001 0z'/>").domain.regions[0].loops[0].size() == 6);
}

TEST_CASE("what is hidden is not drawn, and visibility can come back inside") {
  const auto holes = [](const std::string& content) {
    const auto file = read_svg("<rect width='9' height='9'/>" + content);
    return file.domain.regions.at(0).loops.size() - 1;
  };
  const std::string disc = "<circle cx='4' cy='4' r='1'/>";
  CHECK(holes("<g visibility='visible'>" + disc + "</g>") == 1);
  CHECK(holes("<g visibility='hidden'>" + disc + "</g>") == 0);
  CHECK(holes("<g style='visibility:collapse'>" + disc + "</g>") == 0);
  CHECK(holes("<g visibility='hidden'><g visibility='inherit'>" + disc + "</g></g>") == 0);
  CHECK(holes("<g visibility='hidden'><g style='visibility:visible'>" + disc + "</g></g>") == 1);
  CHECK(holes("<g display='none'><g display='inline'>" + disc + "</g></g>") == 0);
}

TEST_CASE("style sheets hide and fill by name, class and id") {
  const auto read = [](const std::string& sheet, const std::string& shapes) {
    return read_svg("<style>" + sheet + "</style><rect width='9' height='9'/>" + shapes);
  };
  const auto holes = [&](const std::string& sheet, const std::string& attributes) {
    const auto file = read(sheet, "<circle cx='4' cy='4' r='1' " + attributes + "/>");
    CHECK(file.warnings.empty());
    return file.domain.regions.at(0).loops.size() - 1;
  };
  CHECK(holes(".a{display:none}", "") == 1);
  CHECK(holes(".a{display:none}", "class='a'") == 0);
  CHECK(holes(".a{display:none}", "class='b\ta c'") == 0);
  CHECK(holes(".a.b{display:none}", "class='a'") == 1);
  const std::string several = "line , circle.a { stroke:red; visibility : hidden !important } ";
  CHECK(holes(several, "class='b'") == 1);
  CHECK(holes(several, "class='a'") == 0);
  CHECK(holes("/*", "") + holes("/**", "") + holes(".a{", "class='a'") + holes("}", "") == 4);
  CHECK(holes("#x{visibility:hidden}", "id='x'") == 0);
  CHECK(holes("circle{display:none}", "") == 0);
  CHECK(holes("circle{display:none}", "display='inline'") == 0);
  CHECK(holes("circle{display:none}", "style='display:inline'") == 1);
  // The more special selector wins, the later one of equals.
  CHECK(holes(".a{display:none}circle{display:inline}", "class='a'") == 0);
  CHECK(holes("#x{display:inline}.a{display:none}", "class='a' id='x'") == 1);
  CHECK(holes(".a{display:none}.b{display:inline}", "class='b a'") == 1);
  CHECK(holes(".b{display:inline}.a{display:none}", "class='b a'") == 0);
  CHECK(holes("<![CDATA[/* .a{} */ @import url(x); @media print{.a{display:inline}} "
              ".a{display:none}]]>",
              "class='a'") == 0);
  CHECK(holes("@font-face{font-family:x}.c:hover{stroke:red}.a{display:none", "class='a'") == 0);
  CHECK(read(".k{fill:none}", "<path class='k' d='M1 1L2 2 3 1'/>").domain.polylines.size() == 1);
  const auto partly = read("g .a, .a:hover, [x]{display:none}", "");
  REQUIRE(partly.warnings.size() == 1);
  CHECK(partly.warnings[0].message ==
        "Style rules for more than a name, a class or an id were left out: 3.");
}

TEST_CASE("style sheets without text, and within each other, are read once") {
  std::string many;
  for (int i = 0; i < 20'000; ++i) many += "<style/>";
  // What follows an empty element is not in it.
  const auto file = read_svg(many + "<rect width='9' height='9'/>rect{display:none}");
  CHECK(total_area(file.domain) == 81);
  std::string classes, rules;
  for (int i = 0; i < 4'000; ++i) {
    classes += "a ";
    rules += ".a{fill:red}";
  }
  const auto none = read_svg("<style>" + rules +
                             ".a.a{display:none}</style><rect width='9' "
                             "height='9'/><circle r='1' class='" +
                             classes + "'/>");
  CHECK(none.domain.regions.size() == 1);
}

TEST_CASE("SVG that is none, or has nothing to mesh") {
  CHECK(refusal(svg(""), DomainFormat::svg).code == ErrorCode::empty);
  CHECK(refusal(svg("<path fill='none' d='M0 0h1'/>"), DomainFormat::svg).where.has_point);
  for (const char* text :
       {"plain text", "<html></html>", "<svg>", "<svg></sv>", "<svg a></svg>", "<svg a='1></svg>",
        "<svg/><svg/>", "<svg><!-- </svg>", "<svg><![CDATA[ </svg>", "<!DOCTYPE svg [ <svg/>",
        "<svg><rect width='-1' height='1'/></svg>", "<svg><rect width='10%' height='1'/></svg>",
        "<svg><circle r='NaN'/></svg>"}) {
    INFO(text);
    CHECK(refusal(text, DomainFormat::svg).code == ErrorCode::parse_error);
  }
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  CHECK(refusal(svg(deep), DomainFormat::svg).code == ErrorCode::parse_error);
  CHECK(refusal(svg("<rect width='1' height='1' transform='scale(1e308) scale(1e308)'/>"),
                DomainFormat::svg)
            .code == ErrorCode::non_finite);
}

TEST_CASE("XML around the shapes: entities, document types, byte order mark") {
  const std::string text =
      "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
      "\"x>\" [\r\n"
      "<!ENTITY lol \"<rect width='9' height='9'/>\"> <!-- ]> --> ]>\r\n<svg:svg><svg:rect\r\n"
      "id=\"&lt;a&#65;&#x42;&unknown;&gt;\" width='&#50;' height='1' />&lol;</svg:svg>\r\n<!-- end "
      "-->";
  const auto file = lpq_test::read_file(text, DomainFormat::svg);
  REQUIRE(file.domain.regions.size() == 1);
  CHECK(file.domain.regions[0].name == "<aAB&unknown;>");
  CHECK(total_area(file.domain) == 2);
}

// Where SVG draws by views, units and styles, and what is said of that where it is not read.
#include "catch.h"
#include "io/domain/svg_domain.h"
#include "io/domain/svg_values.h"
#include "numerics/elementary.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// In a page of 200 x 100, whose own units say another size.
std::string page(const std::string& content) {
  return "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='10mm' viewBox='0 0 200 "
         "100'>" +
         content + "</svg>";
}

DomainFile read_page(const std::string& content) {
  return lpq_test::read_file(page(content), DomainFormat::svg);
}

using Corners = std::pair<Vec2, Vec2>;

/// The box of the first region, y downwards as in the file.
Corners box_of(const DomainFile& file) {
  const Loop loop = file.domain.regions.at(0).loops.at(0);
  Vec2 lo = loop[0], hi = loop[0];
  for (const Vec2 p : loop) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  return {{lo.x, -hi.y}, {hi.x, -lo.y}};
}
Corners box_of(const std::string& content) { return box_of(read_page(content)); }

double length_of(const std::string& text, const LengthUnits& units = {},
                 LengthAxis axis = LengthAxis::other) {
  double value = 0;
  INFO(text);
  CHECK_FALSE(read_length(text, value, units, axis));
  return value;
}

}  // namespace

TEST_CASE("lengths in all their units") {
  CHECK(length_of("20PX") == 20);
  CHECK(length_of("1In") == 96);
  CHECK(std::abs(length_of("40Q") - length_of("1cm")) < 1e-12);
  CHECK(length_of("2em") == 32);
  CHECK(length_of("2em", {10, {}}) == 20);
  const LengthUnits units{16, Vec2{30, 40}};
  CHECK(length_of("50%", units, LengthAxis::x) == 15);
  CHECK(length_of("50%", units, LengthAxis::y) == 20);
  CHECK(std::abs(length_of("100%", units) - 25 * std::sqrt(2)) < 1e-12);
  double value = 0;
  for (const char* wrong : {"10%", "1 %px", "1furlong", "px", "1px 2"})
    CHECK(read_length(wrong, value));
}

TEST_CASE("percentages and em are of the view and the font around") {
  CHECK(box_of("<rect x='10%' y='10%' width='50%' height='50%'/>") == Corners{{20, 10}, {120, 60}});
  CHECK(box_of("<svg width='50%' height='50'><rect width='100%' height='100%'/></svg>") ==
        Corners{{0, 0}, {100, 50}});
  CHECK(box_of("<svg viewBox='0 0 20 10'><rect width='50%' height='5'/></svg>") ==
        Corners{{0, 0}, {100, 50}});
  CHECK(box_of("<g font-size='10'><g style='font-size:200%'><rect width='2em' height='1em'/></g>"
               "</g>") == Corners{{0, 0}, {40, 20}});
  // Without a viewBox, the page's own size.
  CHECK(box_of(lpq_test::read_file("<svg width='30' height='1in'><rect width='50%' height='50%'/>"
                                   "</svg>",
                                   DomainFormat::svg)) == Corners{{0, 0}, {15, 48}});
  const Error error = refusal("<svg>\n<rect width='9%' height='9'/></svg>", DomainFormat::svg);
  CHECK(error.where.line == 2);
}

TEST_CASE("<svg> in <svg> is a view of its own") {
  const std::string square = "<rect width='100' height='100'/>", size = " width='50' height='50'";
  const auto inner = [&](const std::string& attributes) {
    return box_of("<svg" + attributes + ">" + square + "</svg>");
  };
  CHECK(inner(" x='20' y='10'") == Corners{{20, 10}, {120, 110}});
  CHECK(inner(" x='20' y='10'" + size + " viewBox='0 0 100 100'") == Corners{{20, 10}, {70, 60}});
  CHECK(inner(size + " viewBox='-50 0 200 100' preserveAspectRatio='xMinYMin'") ==
        Corners{{12.5, 0}, {37.5, 25}});
  CHECK(inner(" viewBox='0 0 100 50'") == Corners{{0, 0}, {200, 200}});
  CHECK(inner(size + " x='1' transform='scale(2)' viewBox='0 0 100 100'") ==
        Corners{{2, 0}, {102, 100}});
  const auto nothing = read_page(square +
                                 "<svg width='0' height='9' viewBox='0 0 1 1'>"
                                 "<circle r='1' cx='5' cy='5'/></svg>");
  CHECK(nothing.domain.regions.at(0).loops.size() == 1);
  // For a <use>, whose size counts; a <symbol> without any fills the view.
  CHECK(box_of("<defs><svg id='s' x='1' width='9' height='9' viewBox='0 0 100 100'>" + square +
               "</svg></defs><use href='#s' x='10' width='50' height='50'/>") ==
        Corners{{11, 0}, {61, 50}});
  CHECK(box_of("<symbol id='s' viewBox='0 0 100 100'>" + square + "</symbol><use href='#s'/>") ==
        Corners{{50, 0}, {150, 100}});
}

TEST_CASE("styles move and measure as attributes do") {
  const std::string rect = "<rect width='10' height='20' ";
  CHECK(box_of(rect + "style='transform:scale(2)'/>") == Corners{{0, 0}, {20, 40}});
  CHECK(box_of(rect + "transform='scale(9)' style='transform: translate(50px, 1in)'/>") ==
        Corners{{50, 96}, {60, 116}});
  CHECK(box_of("<style>rect{transform:translateX(5px) scaleY(2)}</style>" + rect + "/>") ==
        Corners{{5, 0}, {15, 40}});
  CHECK(box_of(rect + "transform='none'/>") == Corners{{0, 0}, {10, 20}});
  for (const char* quarter : {"90deg", "100grad", ".25turn"})
    CHECK(box_of(rect + "style='transform:rotate(" + quarter + ")'/>") ==
          Corners{{-20, 0}, {0, 10}});
  const auto origin = [&](const std::string& about) {
    return box_of(rect + "transform='scale(2)' transform-origin='" + about + "'/>");
  };
  CHECK(origin("10 20") == Corners{{-10, -20}, {10, 20}});
  CHECK(origin("left 20px") == Corners{{0, -20}, {20, 20}});
  CHECK(origin("bottom right") == Corners{{-200, -100}, {-180, -60}});
  CHECK(origin("10%") == Corners{{-20, -50}, {0, -10}});
  CHECK(box_of(rect + "transform-origin='10 20'/>") == Corners{{0, 0}, {10, 20}});
  CHECK(box_of(rect + "x='3' style='width:30px;height:auto'/><circle r='1'/>").first.x == -1);
  CHECK(box_of("<style>rect{width:30px;x:5}</style>" + rect + "/>") == Corners{{5, 0}, {35, 20}});
  const auto disk = box_of("<style>circle{r:50px}</style><circle cx='50' cy='50' r='1'/>");
  CHECK(disk == Corners{{0, 0}, {100, 100}});
  CHECK(refusal(page(rect + "style='width:wide'/>"), DomainFormat::svg).code ==
        ErrorCode::parse_error);
}

TEST_CASE("what would hide or move and is not applied is told") {
  const std::string rect = "<rect width='10' height='10' ";
  const auto told = [&](const std::string& content) {
    const auto file = read_page(content);
    CHECK(total_area(file.domain) == 100);
    REQUIRE(file.warnings.size() == 1);
    CHECK(file.warnings[0].code == ErrorCode::ignored);
    return file.warnings[0].message;
  };
  CHECK(told("<clipPath id='c'><rect width='5' height='5' clip-path='url(#d)'/></clipPath><g "
             "clip-path='url(#c)'>" +
             rect + "style='mask:url(#m);clip-path:url(#c)'/></g>")
            .find("Not applied: 2 clip-path and 1 mask. ") == 0);
  for (const char* style : {"style='transform:translate(50%,0)'", "style='transform:rotateX(3deg)'",
                            "transform='scale(-1)' style='transform-box:fill-box'",
                            "transform='scale(-1)' transform-origin='here'"})
    CHECK(told(rect + std::string(style) + "/>").find("Not applied: 1 ") == 0);
  CHECK(told("<path d='M0 0h10v10h-10z' style='d:none'/>").find("Not applied: 1 d of a style.") ==
        0);
  CHECK(read_page(rect + "clip-path='none' style='mask:none'/>").warnings.empty());
}

TEST_CASE("<switch> draws the first child that applies") {
  const std::string one = "<rect width='1' height='1'/>", two = "<rect width='2' height='2'/>";
  const auto area = [](const std::string& children) {
    const auto file = read_page("<switch>" + children + "</switch>");
    CHECK(file.warnings.empty());
    return total_area(file.domain);
  };
  CHECK(area(two + one) == 4);
  CHECK(area("<title>t</title><foreignObject/><g requiredExtensions='x'>" + one + "</g>" + two +
             "<text>t</text>") == 4);
  CHECK(area("<g systemLanguage='de, fr'>" + one + "</g><g systemLanguage='de, EN-gb'>" + two +
             "</g>" + one) == 4);
  CHECK(area("<g>" + two + "<rect x='5' width='1' height='1'/></g>" + one) == 5);
  CHECK(area("<g><switch>" + two + one + "</switch><rect x='5' width='1' height='1'/></g>" + one) ==
        5);
}

TEST_CASE("any prefix of SVG's namespace, and paths of none") {
  const auto file = lpq_test::read_file(
      "<ns0:svg xmlns:ns0='http://www.w3.org/2000/svg' xmlns:ns1='http://www.w3.org/1999/xlink' "
      "xmlns:a='urn:a'><ns0:style>.h{display:none}</ns0:style><a:rect width='50' height='50'/>"
      "<ns0:defs><ns0:g id='g'><ns0:rect width='2' height='1'/></ns0:g></ns0:defs>"
      "<ns0:use ns1:href='#g'/><ns0:rect class='h' width='9' height='9'/><ns0:path d='none'/>"
      "</ns0:svg>",
      DomainFormat::svg);
  CHECK(total_area(file.domain) == 2);
  CHECK(file.warnings.empty());
}

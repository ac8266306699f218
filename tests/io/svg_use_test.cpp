// <use> and <symbol>: where they draw, what they are called, what is refused.
#include "catch.h"
#include "io/domain/svg_domain.h"
#include "io/domain/svg_elements.h"
#include "io/domain/svg_view_box.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainFile read_svg(const std::string& content) {
  return lpq_test::read_file(svg(content), DomainFormat::svg);
}

/// The box of the first region, y downwards as in the file: two corners.
std::pair<Vec2, Vec2> box_of(const std::string& content) {
  const Loop loop = read_svg(content).domain.regions.at(0).loops.at(0);
  Vec2 lo = loop[0], hi = loop[0];
  for (const Vec2 p : loop) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  return {{lo.x, -hi.y}, {hi.x, -lo.y}};
}

using Corners = std::pair<Vec2, Vec2>;
const std::string part = "<defs><rect id='a' x='1' width='2' height='1'/></defs>";

}  // namespace

TEST_CASE("<use> draws its element where it stands") {
  CHECK(box_of(part + "<use href='#a'/>") == Corners{{1, 0}, {3, 1}});
  CHECK(box_of(part + "<use xlink:href='#a' x='5' y='7'/>") == Corners{{6, 7}, {8, 8}});
  // x and y are applied before its transform, which is applied before those around it.
  CHECK(box_of(part + "<use href='#a' x='5' transform='scale(2)'/>") == Corners{{12, 0}, {16, 2}});
  CHECK(box_of(part + "<g transform='translate(1,1)'><use href=' #a ' x='5' transform='scale(-1,1)'"
                      "/></g>") == Corners{{-7, 1}, {-5, 2}});
  // The element may come later, be drawn itself, have a transform of its own and <use> inside.
  const auto file = read_svg(
      "<rect width='90' height='90'/><use href='#pair' x='10' y='10'/><g id='pair'><circle id='c' "
      "cx='20' cy='20' r='3' transform='translate(1)'/><use href='#c' x='40'/></g>");
  REQUIRE(file.domain.regions.at(0).loops.size() == 5);
  CHECK(file.warnings.empty());
  // The same text, and so the same line in an error.
  CHECK(
      refusal(svg("<use href='#b'/>\n\n<defs>\n<path id='b' d='M0 x'/></defs>"), DomainFormat::svg)
          .where.line == 6);
}

TEST_CASE("<use> hands down what it has, and its id is the name") {
  const std::string line = "<defs><path id='l' d='M1 1h2v2'/></defs><rect width='9' height='9'/>";
  CHECK(read_svg(line + "<use href='#l'/>").domain.regions.at(0).loops.size() == 2);
  const auto open =
      read_svg(line + "<g fill='none'><use href='#l'/><use id='x' href='#l' y='4'/></g>");
  REQUIRE(open.domain.polylines.size() == 2);
  CHECK(open.domain.polylines[0].tag == "l");
  CHECK(open.domain.polylines[1].tag == "x");
  const auto none = [&](const std::string& use) {
    return read_svg(line + use).domain.regions.at(0).loops.size() == 1;
  };
  CHECK(none("<use href='#l' display='none'/>"));
  CHECK(none("<use href='#l' visibility='hidden'/>"));
  CHECK(none("<defs><use href='#l'/></defs>"));
  CHECK(none("<symbol id='s'><use href='#l'/></symbol>"));
}

TEST_CASE("a <symbol> fills the size of its <use> with its view box") {
  const auto symbol = [](const std::string& attributes) {
    return "<symbol id='s' " + attributes +
           "><rect x='10' y='20' width='30' height='10'/></symbol>";
  };
  const std::string use = "<use href='#s' x='100' y='200' ";
  CHECK(box_of(symbol("") + use + "/>") == Corners{{110, 220}, {140, 230}});
  CHECK(box_of(symbol("viewBox='0 0 60 60'") + use + "/>") == Corners{{110, 220}, {140, 230}});
  const std::string box = "viewBox='10,20,30,10'", size = "width='60' height='60'/>";
  CHECK(box_of(symbol(box) + use + size) == Corners{{100, 220}, {160, 240}});
  CHECK(box_of(symbol(box + " preserveAspectRatio='xMaxYMin'") + use + size) ==
        Corners{{100, 200}, {160, 220}});
  CHECK(box_of(symbol(box + " preserveAspectRatio='none'") + use + size) ==
        Corners{{100, 200}, {160, 260}});
  CHECK(box_of(symbol(box + " preserveAspectRatio='xMinYMid slice'") + use + size) ==
        Corners{{100, 200}, {280, 260}});
  CHECK(box_of(symbol(box + " width='15' height='5'") + use + "/>") ==
        Corners{{100, 200}, {115, 205}});
  for (const char* wrong : {"viewBox='0 0 1'", "viewBox='0 0 0 1'", "viewBox='a'"})
    CHECK(refusal(svg(symbol(wrong) + use + size), DomainFormat::svg).code ==
          ErrorCode::parse_error);
}

TEST_CASE("<use> that leads nowhere, round in circles or without end") {
  const auto file = read_svg("<rect width='9' height='9'/><use href='b.svg#c'/><use href='#c'/>");
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].message ==
        "Left out: 1 use of another file and 1 use without its element.");
  for (const char* circle :
       {"<g id='a'><use href='#a'/></g>", "<use id='a' href='#a'/>",
        "<defs><g id='a'><use href='#b'/></g></defs><g id='b'><use href='#a'/></g>"}) {
    INFO(circle);
    const Error error = refusal(svg(circle), DomainFormat::svg);
    CHECK(error.code == ErrorCode::parse_error);
    CHECK(error.message == "This <use> is part of what it draws.");
    CHECK(error.where.line == 3);
  }
  const auto tower = [](std::size_t height, int copies) {
    std::string content = "<rect width='9' height='9'/><use href='#g0'/><defs>";
    for (std::size_t i = 0; i < height; ++i) {
      content += "<g id='g" + std::to_string(i) + "'>";
      for (int c = 0; c < copies; ++c) content += "<use href='#g" + std::to_string(i + 1) + "'/>";
      content += "</g>";
    }
    return svg(content + "<g id='g" + std::to_string(height) + "'/></defs>");
  };
  CHECK(read_domain(tower(deepest_use - 1, 1), DomainFormat::svg).has_value());
  CHECK(refusal(tower(deepest_use, 1), DomainFormat::svg).code == ErrorCode::too_large);
  CHECK(refusal(tower(25, 2), DomainFormat::svg).code == ErrorCode::too_large);
}

// Pictures are well-formed, small, and put things where they belong.
#include "catch.h"
#include "delaunay/delaunay.h"
#include "io/picture/svg.h"
#include "io/picture/svg_canvas.h"
#include "support/output_meshes.h"

using namespace lpq;

namespace {

/// Every tag closed in order, attributes quoted: enough to catch a broken writer.
bool well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return false;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("quad pictures are well-formed and have few paths") {
  const std::string picture = draw_quads(lpq_test::grid_mesh(20));
  CHECK(well_formed(picture));
  CHECK(count(picture, "<path") == 3);  // one colour, thin edges, thick edges
  CHECK(count(picture, "Z") == 400);
  CHECK(count(picture, "<circle") == 0);  // a grid has no irregular vertex
  CHECK(picture.find("viewBox=\"0 0 1000 1044\"") != std::string::npos);
}

TEST_CASE("irregular vertices are marked by their valence") {
  // Three quads around a centre: valence 3.
  OutputMesh mesh;
  mesh.points = {{0, 0}, {2, 0}, {1, 1.7}, {-1, 1.7}, {-2, 0}, {-1, -1.7}, {1, -1.7}};
  mesh.faces = {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
  mesh.region = {0, 0, 0};
  mesh.regions = {""};
  const std::string picture = draw_quads(mesh);
  CHECK(count(picture, "<circle") == 1);
  CHECK(picture.find("fill=\"#1f5fd0\"") != std::string::npos);
}

TEST_CASE("triangles and cells draw") {
  std::vector<Vec2> points;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) points.push_back({0.2 * i + 0.01 * j, 0.2 * j});
  const auto mesh = triangulate(points);
  REQUIRE(mesh.has_value());
  CHECK(well_formed(draw_triangles(*mesh)));
}

TEST_CASE("colours blend between their stops") {
  const Colour stops[] = {{0, 0, 0}, {100, 200, 50}, {255, 255, 255}};
  CHECK(colour_text(blend(stops, 0)) == "#000000");
  CHECK(colour_text(blend(stops, 0.25)) == "#326419");
  CHECK(colour_text(blend(stops, 1)) == "#ffffff");
  CHECK(colour_text(blend(stops, 7)) == "#ffffff");
  CHECK(colour_text(blend(stops, std::nan(""))) == "#000000");
}

TEST_CASE("extreme coordinates still fit the page") {
  for (const double scale : {1e-300, 1.0, 1e300}) {
    OutputMesh mesh = lpq_test::grid_mesh(2);
    for (Vec2& p : mesh.points) p = scale * p;
    CHECK(well_formed(draw_quads(mesh)));
  }
}

// The surface readers: every format gives the same box, and what is wrong is refused in its place.
#include "support/surface_files.h"

#include "catch.h"
#include "io/surface/obj_surface.h"
#include "io/surface/stl_surface.h"
#include "support/surface_checks.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

SurfaceSoup good(const Result<SurfaceSoup>& soup) {
  INFO((soup ? std::string() : soup.error().message));
  REQUIRE(soup.has_value());
  return soup.value();
}

Error bad(const Result<SurfaceSoup>& soup) {
  REQUIRE_FALSE(soup.has_value());
  CHECK_FALSE(soup.error().message.empty());
  return soup.error();
}

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("OBJ: corners, groups, continued lines") {
  const auto box = good(read_obj_surface(obj_text(box_soup({1, 2, 3}, 2))));
  CHECK(area_of(box.points, box.triangles) == Approx(22));
  CHECK(box.group_names == std::vector<std::string>{""});

  const auto odd = good(read_obj_surface(
      "\xEF\xBB\xBFmtllib x.mtl\r\nv 0 0 0 nan nan nan\r\nv\t1 0 0\r\nv 1 1e0 0 # here\r\nv 0 1 "
      "0\r\n"
      "vt 0 0\r\nf 1 2/1 3//7\r\no part one\r\nusemtl steel\r\nf -4 \\\r\n -2 -1\r\ng g\r\ng\r\n"
      "f 1 2 3 4\r\nl 1 2\r\ncurv 1"));
  CHECK(odd.triangles.size() == 4);
  CHECK(odd.triangles[1] == Tri{0, 2, 3});
  CHECK(odd.group == std::vector<Index>{0, 1, 1, 1});
  CHECK(odd.group_names == std::vector<std::string>{"", "part one/steel"});
  CHECK(odd.warnings.empty());
}

TEST_CASE("OBJ: a polygon with an inward corner keeps its area") {
  const std::string arrow = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
  for (const std::string face : {"f 1 2 3 4\n", "f 2 3 4 1\n", "f 3 4 1 2\n", "f 4 1 2 3\n"}) {
    const auto soup = good(read_obj_surface(arrow + face));
    CHECK(area_of(soup.points, soup.triangles) == Approx(4));
  }
}

TEST_CASE("OBJ: what is wrong has a line") {
  CHECK(bad(read_obj_surface("")).code == ErrorCode::empty);
  CHECK(bad(read_obj_surface(three_points)).code == ErrorCode::empty);
  CHECK(bad(read_obj_surface(three_points + "f 1 2 4\n")).where.line == 4);
  CHECK(bad(read_obj_surface(three_points + "f 1 2 0\n")).where.line == 4);
  CHECK(bad(read_obj_surface(three_points + "f 1 2 -4\n")).where.byte == 24);
  CHECK(bad(read_obj_surface(three_points + "f 1 2 x\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_obj_surface(three_points + "f 1 2 99999999999999999999\n")).where.line == 4);
  CHECK(bad(read_obj_surface("v 0 0\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_obj_surface("v 0 0 -nan\n")).code == ErrorCode::non_finite);
  CHECK(bad(read_obj_surface("\nv 0 inf 0\n")).where.line == 2);
  const auto short_face = good(read_obj_surface(three_points + "f 1 2\nf 1 2 3\nf\n"));
  CHECK(short_face.triangles.size() == 1);
  REQUIRE(short_face.warnings.size() == 1);
  CHECK(short_face.warnings[0].where.line == 4);
}

TEST_CASE("STL: bytes and text") {
  const SurfaceSoup box = box_soup({1, 2, 3}, 2);
  for (const std::string& header : {std::string(), std::string("solid in name only\nfacet")}) {
    const auto soup = good(read_stl_surface(binary_stl(box, header)));
    CHECK(soup.triangles.size() == box.triangles.size());
    CHECK(area_of(soup.points, soup.triangles) == Approx(22));
  }
  const auto soup = good(read_stl_surface(text_stl(box)));
  CHECK(area_of(soup.points, soup.triangles) == Approx(22));
  CHECK(soup.group_names == std::vector<std::string>{"a box"});
  const auto two = good(read_stl_surface("\r\n" + text_stl(box) + text_stl(box)));
  CHECK(two.group_names == std::vector<std::string>{"a box", "a box"});
  CHECK(two.group.back() == 1);
  const auto line = good(read_stl_surface(
      "SOLID\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 "
      "ENDLOOP ENDFACET ENDSOLID"));
  CHECK(line.triangles.size() == 1);
}

TEST_CASE("STL: what is wrong has a place") {
  const std::string bytes = binary_stl(box_soup({1, 1, 1}, 1));
  CHECK(bad(read_stl_surface("")).code == ErrorCode::parse_error);
  CHECK(bad(read_stl_surface(bytes.substr(0, 83))).where.byte == 83);
  CHECK(bad(read_stl_surface(bytes.substr(0, 84))).code == ErrorCode::parse_error);
  CHECK(bad(read_stl_surface(bytes.substr(0, bytes.size() - 1))).code == ErrorCode::parse_error);
  CHECK(read_stl_surface(bytes + "xyz").has_value());
  std::string endless = bytes;
  for (std::size_t k = 80; k < 84; ++k) endless[k] = '\xff';
  CHECK(bad(read_stl_surface(endless)).code == ErrorCode::parse_error);
  std::string nan = bytes;
  for (std::size_t k = 0; k < 4; ++k) nan[84 + 12 + k] = '\xff';
  CHECK(bad(read_stl_surface(nan)).code == ErrorCode::non_finite);
  CHECK(bad(read_stl_surface(nan)).where.byte == 96);
  std::string none_at_all(84, '\0');
  CHECK(bad(read_stl_surface(none_at_all)).code == ErrorCode::empty);

  CHECK(bad(read_stl_surface("solid\nendsolid")).code == ErrorCode::empty);
  const std::string facet = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  CHECK(bad(read_stl_surface(facet)).code == ErrorCode::parse_error);
  CHECK(bad(read_stl_surface(facet + "endloop\nendfacet\n")).where.line == 7);
  CHECK(bad(read_stl_surface(facet + "vertex 0 1\nendloop\n")).where.line == 7);
  CHECK(bad(read_stl_surface(facet + "vertex 0 1 nan\n")).code == ErrorCode::non_finite);
  CHECK(bad(read_stl_surface("solid\nvertex 0 0 0\n")).where.line == 2);
  CHECK(bad(read_stl_surface(facet + "facet")).where.line == 6);
  CHECK(bad(read_stl_surface(facet + "solid")).where.line == 6);
  CHECK(bad(read_stl_surface("solid\ntriangle\n")).where.line == 2);
}

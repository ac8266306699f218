// The surface readers: every format gives the same box, and what is wrong is refused in its place.
#include "support/surface_files.h"

#include "catch.h"
#include "io/mesh/msh.h"
#include "io/surface/msh_surface.h"
#include "io/surface/obj_surface.h"
#include "io/surface/off_surface.h"
#include "io/surface/ply_surface.h"
#include "io/surface/stl_surface.h"
#include "io/surface/surface_format.h"
#include "io/surface/surface_write.h"
#include "support/output_meshes.h"
#include "support/read_soup.h"
#include "support/surface_checks.h"
#include "support/surface_data.h"
#include "support/surface_shapes.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("faces of an OFF file may be spread over lines") {
  const std::string points = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto spread = read_surface_file("a.off", points + "3 0\n1\n2\n\n3 0 2\n 3\n");
  REQUIRE(spread.has_value());
  CHECK(spread->triangles == std::vector<Tri>{{0, 1, 2}, {0, 2, 3}});
  const auto wrong = read_surface_file("a.off", points + "3 0 1\n3 0 2 3\n");
  REQUIRE_FALSE(wrong.has_value());
  CHECK(wrong.error().message.find("fewer corners") != std::string::npos);
  CHECK_FALSE(read_surface_file("a.off", points + "3 0 1 2\n3 0 2\n").has_value());
}

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

TEST_CASE("OBJ: objects are bodies where they are closed, and come back") {
  const auto objects = [](const SurfaceSoup& soup) {
    std::string text;
    for (const Vec3 p : soup.points)
      text +=
          "v " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      if (t == 0 || soup.body[t] != soup.body[t - 1])
        text += "o body " + std::to_string(soup.body[t]) + "\ng body " +
                std::to_string(soup.body[t]) + " face\n";
      text += 'f';
      for (const Index v : soup.triangles[t]) text += ' ' + std::to_string(v + 1);
      text += '\n';
    }
    return text;
  };
  SurfaceSoup boxes = touching_boxes(1);
  const auto two = good(read_obj_surface(objects(boxes)));
  CHECK(two.body == boxes.body);
  CHECK(two.body_names == std::vector<std::string>{"body 0", "body 1"});
  CHECK(two.group_names == std::vector<std::string>{"body 0 face", "body 1 face"});
  const auto repaired = repair_surface(two);
  REQUIRE(repaired.has_value());
  const std::string text =
      write_surface_obj(repaired->mesh, repaired->group_names, repaired->body_names);
  const auto again = good(read_obj_surface(text));
  CHECK(again.body == two.body);
  CHECK(again.body_names == std::vector<std::string>{"body_0", "body_1"});
  CHECK(again.group_names == std::vector<std::string>{"body_0_face", "body_1_face"});
  boxes.triangles.pop_back();  // both open: sheets that may belong together
  boxes.triangles.erase(boxes.triangles.begin());
  boxes.body.pop_back();
  boxes.body.erase(boxes.body.begin());
  CHECK(good(read_obj_surface(objects(boxes))).body_names.size() == 1);
}

TEST_CASE("OBJ: a polygon with an inward corner keeps its area") {
  const std::string arrow = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
  for (const std::string face : {"f 1 2 3 4\n", "f 2 3 4 1\n", "f 3 4 1 2\n", "f 4 1 2 3\n"}) {
    const auto soup = good(read_obj_surface(arrow + face));
    CHECK(area_of(soup.points, soup.triangles) == Approx(4));
  }
}

TEST_CASE("OBJ: polygons that no corner sees whole keep their area, and turn with them") {
  // A comb of five teeth, tilted in space, from every corner and both ways round.
  std::vector<Vec2> outline{{10, -1}, {0, -1}};
  for (int i = 0; i < 10; ++i) outline.push_back({double(i), i % 2 == 0 ? 3.0 : 0.2});
  std::reverse(outline.begin(), outline.end());
  std::string points;
  for (const Vec2 p : outline)
    points += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
              std::to_string(0.5 * p.x) + "\n";
  const int n = static_cast<int>(outline.size());
  for (int first = 0; first < n; ++first)
    for (const bool back : {false, true}) {
      std::string face = "f";
      for (int k = 0; k < n; ++k)
        face += " " + std::to_string(1 + (first + (back ? n - k : k)) % n);
      const auto soup = good(read_obj_surface(points + face + "\n"));
      CHECK(soup.triangles.size() == outline.size() - 2);
      CHECK(soup.warnings.empty());
      double area = 0;
      for (std::size_t i = 0; i < outline.size(); ++i)
        area += 0.5 * cross(outline[i], outline[(i + 1) % outline.size()]);
      CHECK(area_of(soup.points, soup.triangles) == Approx(std::abs(area) * std::sqrt(1.25)));
      for (const auto& [a, b, c] : soup.triangles) {
        const Vec3 turn = cross(soup.points[b] - soup.points[a], soup.points[c] - soup.points[a]);
        CHECK((turn.z > 0) == ((area > 0) != back));
      }
    }
}

TEST_CASE("OBJ: a hole that a bridge leads to stays open; a polygon across itself is told") {
  const auto ring = good(
      read_obj_surface("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n"
                       "f 1 2 3 4 1 5 6 7 8 5\n"));
  CHECK(area_of(ring.points, ring.triangles) == Approx(12));
  CHECK(ring.warnings.empty());
  const auto star =
      good(read_obj_surface("v 0 0 0\nv 4 0 0\nv 0 3 0\nv 2 -2 0\nv 4 3 0\nf 1 2 3 4 5\n"));
  REQUIRE(star.warnings.size() == 1);
  CHECK(star.warnings[0].code == ErrorCode::self_intersection);
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
  // Also where its length is not what it says.
  CHECK(good(read_stl_surface(binary_stl(box, "solid in name only") + "xyz")).triangles.size() ==
        box.triangles.size());
  const auto soup = good(read_stl_surface(text_stl(box)));
  CHECK(area_of(soup.points, soup.triangles) == Approx(22));
  CHECK(soup.group_names == std::vector<std::string>{"a box"});
  const auto two = good(read_stl_surface("\r\n" + text_stl(box) + text_stl(box)));
  CHECK(two.group_names == std::vector<std::string>{"a box", "a box"});
  CHECK(two.group.back() == 1);
  std::string numbered = text_stl(box);
  numbered.replace(numbered.find("a box"), 5, "part #1");
  CHECK(good(read_stl_surface(numbered)).group_names == std::vector<std::string>{"part #1"});
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
  std::string uncounted = bytes;
  for (std::size_t k = 80; k < 84; ++k) uncounted[k] = '\0';
  CHECK(bad(read_stl_surface(uncounted)).where.byte == 80);
  CHECK(bad(read_stl_surface(uncounted)).message.find("0 facets") != std::string::npos);

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

TEST_CASE("OFF: headers, white space, colours") {
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0 255 0 0\n4 0 1 2 3 1.0 0 0\n";
  for (const std::string head :
       {"OFF\n4 1 0\n", "OFF 4 1 0\n", "# x\n\nOFF4 1 # y\n", "4 1 4\r\n", "COFF\n4 1 0\n\n",
        "STCNOFF 4 1\n", "off 4 1 0\n", "# a\r\n# b\n\nstoff\n# c\n4 1\n", "NOFF\n#\n4 1 0\n"}) {
    const bool has_keyword = head.find_first_of("Oo") != std::string::npos;
    CHECK((surface_format_by_content(head + square) == SurfaceFormat::off) == has_keyword);
    const auto soup = good(read_off_surface(head + square));
    CHECK(soup.triangles.size() == 2);
    CHECK(area_of(soup.points, soup.triangles) == Approx(1));
  }
  const auto odd = good(read_off_surface("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n0\n"));
  CHECK(odd.triangles.size() == 1);
  REQUIRE(odd.warnings.size() == 1);
  CHECK(odd.warnings[0].where.line == 6);
}

TEST_CASE("OFF: what is wrong has a line") {
  CHECK(bad(read_off_surface("")).code == ErrorCode::parse_error);
  CHECK(bad(read_off_surface("OFF")).code == ErrorCode::parse_error);
  CHECK(bad(read_off_surface("OFF BINARY\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_off_surface("off binary\n")).message ==
        bad(read_off_surface("OFF BINARY\n")).message);
  CHECK(bad(read_off_surface("4off\n1 1 1\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_off_surface("4OFF\n1 1 1\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_off_surface("OFF\n0 0 0\n")).code == ErrorCode::empty);
  CHECK(bad(read_off_surface("OFF\n-3 -1 0\n")).code == ErrorCode::empty);
  CHECK(bad(read_off_surface("OFF\n9999999999 1 0\n0 0 0\n")).where.line == 3);
  CHECK(bad(read_off_surface("OFF\n1 1 0\n0 nan 0\n")).code == ErrorCode::non_finite);
  const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  CHECK(bad(read_off_surface(three)).code == ErrorCode::parse_error);
  CHECK(bad(read_off_surface(three + "3 0 1 3\n")).where.line == 6);
  CHECK(bad(read_off_surface(three + "4 0 1 2\n")).where.line == 6);
  CHECK(bad(read_off_surface(three + "99999999999999 0 1 2\n")).where.line == 6);
  CHECK(bad(read_off_surface(three + "3 0 1 1.5\n")).where.line == 6);
}

TEST_CASE("PLY: text and bytes of both orders") {
  const SurfaceSoup box = box_soup({1, 2, 3}, 2);
  for (const std::string& bytes : {text_ply(box), binary_ply(box, false), binary_ply(box, true)}) {
    const auto soup = good(read_ply_surface(bytes));
    CHECK(soup.triangles == box.triangles);
    CHECK(area_of(soup.points, soup.triangles) == Approx(22));
    CHECK(soup.group_names == std::vector<std::string>{"0", "1"});
    CHECK(soup.group[3] == 1);
  }
  std::string crlf;
  for (const char c : text_ply(box)) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(good(read_ply_surface(crlf)).triangles == box.triangles);
}

TEST_CASE("PLY: strips of triangles") {
  const auto read = [](const std::string& strip) {
    return read_ply_surface(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n" +
        strip);
  };
  const std::vector<Tri> rising{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
  CHECK(good(read("5 0 1 2 3 4\n")).triangles == rising);
  // A new strip starts the one way round; a turn by a vertex said twice keeps to it.
  CHECK(good(read("8 0 1 2 3 -1 2 3 4\n")).triangles == rising);
  CHECK(good(read("6 0 1 1 3 2 0\n")).triangles == std::vector<Tri>{{1, 3, 2}, {2, 3, 0}});
  CHECK(bad(read("3 0 1 5\n")).message.find("vertex 5") != std::string::npos);
  CHECK(bad(read("3 0 1 -2\n")).where.line == 15);
  CHECK(bad(read("3 0 1\n")).code == ErrorCode::parse_error);
  CHECK(bad(read("2 0 1\n")).code == ErrorCode::empty);
}

TEST_CASE("PLY: a size at every vertex") {
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n";
  const std::string tail =
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const auto read = [&](const std::string& size, const std::string& vertices) {
    return read_ply_surface(head + size + tail + vertices + "3 0 1 2\n");
  };
  const std::string size = "property double size\n";
  CHECK(good(read(size, "0 0.25 0 0\n1 0.5 0 0\n0 0 1 0\n")).sizes ==
        std::vector<double>{0.25, 0.5, 0});
  CHECK(good(read("", "0 0 0\n1 0 0\n0 1 0\n")).sizes.empty());
  CHECK(
      good(read("property list uchar float size\n", "0 0 0 0\n1 0 0 0\n0 0 1 0\n")).sizes.empty());
  CHECK(bad(read(size, "0 nan 0 0\n1 0.5 0 0\n0 0 1 0\n")).code == ErrorCode::non_finite);
}

TEST_CASE("PLY: what is wrong has a place") {
  CHECK(bad(read_ply_surface("")).code == ErrorCode::parse_error);
  CHECK(bad(read_ply_surface("ply\nformat ascii 1.0\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_ply_surface("ply\nend_header\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_ply_surface("ply\nformat ascii 1.0\nend_header\n")).code == ErrorCode::empty);
  CHECK(bad(read_ply_surface("ply\nformat binary 1.0\nend_header\n")).where.line == 2);
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 1\n";
  for (const std::string line :
       {"property float\n", "property real x\n", "property list float int x\n",
        "property list int\n", "element face -1\n", "elements\n"})
    CHECK(bad(read_ply_surface(head + line + "end_header\n")).where.line == 4);
  CHECK(bad(read_ply_surface(head + "property float x\nend_header\n1\n")).code ==
        ErrorCode::parse_error);
  const std::string vertices = head + "property float x\nproperty float y\nproperty float z\n";
  CHECK(bad(read_ply_surface(vertices + "end_header\n1 2 nan\n")).code == ErrorCode::non_finite);
  CHECK(bad(read_ply_surface(vertices + "end_header\n1 2 x\n")).where.line == 8);
  const std::string faces = vertices + "element face 1\nproperty list char int vertex_index\n";
  CHECK(bad(read_ply_surface(faces + "end_header\n1 2 3\n3 0 0 1\n")).where.line == 11);
  CHECK(bad(read_ply_surface(faces + "end_header\n1 2 3\n-3 0 0 0\n")).where.line == 11);
  CHECK(bad(read_ply_surface(faces + "end_header\n1 2 3\n3 0 0\n")).code == ErrorCode::parse_error);
  CHECK(bad(read_ply_surface(vertices + "element face 1\nproperty int n\nend_header\n1 2 3\n3\n"))
            .code == ErrorCode::parse_error);
  const std::string bytes = binary_ply(box_soup({1, 1, 1}, 1), true);
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    CHECK(bad(read_ply_surface(bytes.substr(0, size))).code == ErrorCode::parse_error);
}

TEST_CASE("MSH: groups from physical and elementary surfaces") {
  const SurfaceSoup box = box_soup({1, 2, 3}, 2);
  const auto soup = good(read_msh_surface(msh_text(box)));
  CHECK(soup.triangles == box.triangles);
  CHECK(soup.group_names == std::vector<std::string>{"even", "physical surface 2"});
  // Our own plane meshes, in both versions, as surfaces: quads are halved.
  for (const MshVersion version : {MshVersion::v4_1, MshVersion::v2_2}) {
    const OutputMesh plane = two_region_mesh();
    const auto mesh = good(read_msh_surface(write_msh(plane, version)));
    CHECK(mesh.group_names.size() == 2);
    CHECK(mesh.triangles.size() >= plane.faces.size());
  }
  const std::string head =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 2\n"
      "4 .5 0 0\n5 .5 .5 1\n6 0 .5 1\n$EndNodes\n$Elements\n2\n";
  const auto curved =
      good(read_msh_surface(head + "1 4 2 0 1 1 2 3 4\n2 9 2 0 3 1 2 3 4 5 6\n$EndElements\n"));
  CHECK(curved.triangles.size() == 1);
  CHECK(curved.group_names == std::vector<std::string>{"surface 3"});
  REQUIRE(curved.warnings.size() == 2);  // of the volume, of the second order
  CHECK(curved.warnings[0].code == ErrorCode::ignored);
  CHECK(curved.warnings[1].code == ErrorCode::adapted);
  CHECK(bad(read_msh_surface(head + "1 15 2 0 1 1\n2 15 2 0 1 2\n$EndElements\n")).code ==
        ErrorCode::empty);
  CHECK(bad(read_msh_surface(head + "1 15 2 0 1 1\n2 2 2 0 1 2 3 9\n$EndElements\n")).where.line ==
        16);
  CHECK(bad(read_msh_surface("$MeshFormat\n4 1 8\n")).code == ErrorCode::parse_error);
}

TEST_CASE("surface formats by name, ending and content") {
  const SurfaceSoup box = box_soup({1, 1, 1}, 1);
  const std::pair<SurfaceFormat, std::string> samples[] = {
      {SurfaceFormat::obj, obj_text(box)},
      {SurfaceFormat::off, off_text(box)},
      {SurfaceFormat::stl, text_stl(box)},
      {SurfaceFormat::stl, binary_stl(box)},
      {SurfaceFormat::stl, binary_stl(box, "solid")},
      {SurfaceFormat::ply, text_ply(box)},
      {SurfaceFormat::ply, binary_ply(box, true)},
      {SurfaceFormat::msh, msh_text(box)}};
  for (const auto& [format, bytes] : samples) {
    INFO(static_cast<int>(format));
    CHECK(surface_format_by_content(bytes) == format);
    const auto soup = good(read_surface_file("-", bytes));
    const auto surface = repair_surface(soup);
    REQUIRE(surface.has_value());
    check_surface(surface->mesh);
    CHECK(volume_of(surface->mesh) == Approx(1));
  }
  CHECK(surface_format_by_ending("a.b/part.STL") == SurfaceFormat::stl);
  CHECK_FALSE(surface_format_by_ending("stl"));
  CHECK_FALSE(surface_format_by_content(""));
  CHECK_FALSE(surface_format_by_content("{}"));
  CHECK(bad(read_surface_file("part.step", "ISO-10303-21;")).code == ErrorCode::parse_error);
}

TEST_CASE("odd and malformed files of the shared data: a surface or a sentence") {
  int read = 0;
  for (const auto& path : shared_surfaces("formats")) {
    INFO(path.filename());
    const std::string bytes = read_bytes(path);
    for (const SurfaceFormatInfo& one : surface_formats) {
      const auto soup = read_surface(bytes, one.format);
      if (!soup) CHECK_FALSE(soup.error().message.empty());
    }
    if (!surface_format_by_ending(path.filename().string())) continue;
    const auto soup = read_surface_file(path.filename().string(), bytes);
    const std::string name = path.filename().string();
    const bool refused = name == "empty.stl" || name == "points_emptyface.ply";
    INFO((soup ? std::string() : soup.error().message));
    CHECK(soup.has_value() == !refused);
    if (!soup) continue;
    const auto surface = repair_surface(*soup);
    REQUIRE(surface.has_value());
    check_surface(surface->mesh);
    ++read;
  }
  CHECK((read == 0 || read >= 12));
}

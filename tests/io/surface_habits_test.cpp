// The surface readers: what is unusual in files, but good.
#include <algorithm>

#include "catch.h"
#include "io/surface/obj_surface.h"
#include "io/surface/off_surface.h"
#include "io/surface/ply_surface.h"
#include "io/surface/surface_write.h"
#include "support/read_soup.h"
#include "support/surface_checks.h"
#include "support/surface_files.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("OBJ: vertices may come after the faces that name them") {
  const std::string face = "o a\ng one\nf 3 1 2\ng two\nf 2 4 3\n";
  const std::string points = three_points + "v 1 1 0\n";
  const auto before = good(read_obj_surface(points + face));
  for (const std::string& text : {face + points, "v 0 0 0\n" + face + points.substr(8)}) {
    const auto after = good(read_obj_surface(text));
    CHECK(after.triangles == before.triangles);
    CHECK(after.group == before.group);
    CHECK(after.group_names == before.group_names);
    CHECK(after.body == before.body);
  }
  // The place is that of the face.
  const Error missing = bad(read_obj_surface("f 1 2 3\nf 1 2 4\n" + three_points));
  CHECK(missing.where.line == 2);
  CHECK(missing.message.find("vertex 4") != std::string::npos);
  CHECK(bad(read_obj_surface("f 1 2 -1\n" + three_points)).where.line == 1);
}

TEST_CASE("OBJ: comments go on nowhere, lines after backslashes with blanks behind, names have #") {
  const auto soup = good(read_obj_surface("# from C:\\models\\\n" + three_points +
                                          "g part #1\nf 1 2 \\ \t\n3 # so \\\n"
                                          "g part #2 # x\nusemtl #steel\nf 1 2 \\\r\n3\r\n"));
  CHECK(soup.points.size() == 3);
  CHECK(soup.triangles.size() == 2);
  CHECK(soup.group_names == std::vector<std::string>{"part #1", "part #2 # x/#steel"});
}

TEST_CASE("OBJ: groups stay apart whatever their names are") {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::string> names{"#1", "#2", "a b", "a_b", "same", "same", "", "group_7"};
  for (Index g = 0; g < static_cast<Index>(names.size()); ++g) {
    mesh.triangles.push_back({0, 1, 2});
    mesh.group.push_back(g);
  }
  const auto again = good(read_obj_surface(write_surface_obj(mesh, names)));
  CHECK(again.group_names.size() == names.size());
  CHECK(again.group == mesh.group);
}

TEST_CASE("OFF: vertices anyhow on lines, and with weights") {
  const std::string faces = "3 0 1 2\n3 0 2 3 255 0 0\n";
  for (const std::string vertices :
       {"4 2 5\n0 0 0  1 0 0  1 1 0  0 1 0\n", "4 2 5\n0 0 0 1 0 0\n1 1 0 0 1 0\n",
        "4\n2\n0\n0 0\n0 1 0 0\n1 1\n0 # here\n\n0 1 0\n", "4 2 0 0 0 0 1 0 0 1 1 0 0 1 0\n"}) {
    for (const std::string head : {"OFF\n", "OFF ", ""}) {
      INFO(head + vertices);
      const auto soup = good(read_off_surface(head + vertices + faces));
      CHECK(soup.triangles == std::vector<Tri>{{0, 1, 2}, {0, 2, 3}});
      CHECK(area_of(soup.points, soup.triangles) == Approx(1));
    }
  }
  const auto weighted =
      good(read_off_surface("4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 -4 0 -4\n3 0 1 2\n"));
  CHECK(weighted.points == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(bad(read_off_surface("4OFF\n1 1 0\n1 0 0 0\n3 0 0 0\n")).where.line == 3);
  CHECK(bad(read_off_surface("4OFF\n1 1 0\n1 0 0\n3 0 0 0\n")).where.line == 3);
}

TEST_CASE("PLY: faces may come before their vertices") {
  const std::string head =
      "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\n"
      "property int group\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto soup = good(read_ply_surface(head + "3 0 1 2 7\n3 0 2 3 8\n" + points));
  CHECK(soup.triangles == std::vector<Tri>{{0, 1, 2}, {0, 2, 3}});
  CHECK(soup.group_names == std::vector<std::string>{"7", "8"});
  CHECK(soup.group == std::vector<Index>{0, 1});
  CHECK(bad(read_ply_surface(head + "3 0 1 2 7\n3 0 2 4 8\n" + points)).where.line == 12);
  CHECK(bad(read_ply_surface(head + "3 0 1 2 7\n3 0 2 3 8\n" + points.substr(6))).code ==
        ErrorCode::parse_error);
}

TEST_CASE("PLY: a header of lines that end in CR alone, before data of a line feed") {
  const std::string box = binary_ply(box_soup({1, 1, 1}, 1), false);
  const std::size_t data = box.find("end_header\n") + 11;
  std::string bytes = box;
  std::replace(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(data), '\n', '\r');
  for (const char first : {'\n', '\0'}) {
    bytes[data] = first;  // the last digits of a coordinate
    const auto soup = good(read_ply_surface(bytes));
    CHECK(soup.triangles == box_soup({1, 1, 1}, 1).triangles);
  }
}

TEST_CASE("PLY: bytes that are cut off end before the last element") {
  const std::string box = binary_ply(box_soup({1, 1, 1}, 1), false);
  for (std::size_t cut = 1; cut < 30; ++cut) {
    const Error error = bad(read_ply_surface(box.substr(0, box.size() - cut)));
    CHECK(error.message.find("ends before its last element") != std::string::npos);
  }
}

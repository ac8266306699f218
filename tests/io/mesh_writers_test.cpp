// The text of each format: counts, columns, names. Other programs read the files in tests/outside.
#include <algorithm>
#include <set>
#include <sstream>

#include "catch.h"
#include "io/mesh/bdf.h"
#include "io/mesh/edge_sides.h"
#include "io/mesh/geojson.h"
#include "io/mesh/inp.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/msh.h"
#include "io/mesh/obj.h"
#include "io/mesh/ply.h"
#include "io/mesh/su2.h"
#include "io/mesh/vtk.h"
#include "support/output_meshes.h"

using namespace lpq;
using lpq_test::grid_mesh;
using lpq_test::thrice_named_mesh;
using lpq_test::two_region_mesh;

namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

std::ptrdiff_t count_starts(const std::string& text, const std::string& start) {
  const auto all = lines(text);
  return std::count_if(all.begin(), all.end(),
                       [&](const std::string& line) { return line.rfind(start, 0) == 0; });
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// two_region_mesh with an inner edge and these names for regions and tags.
OutputMesh named_mesh(const std::vector<std::string>& names) {
  OutputMesh mesh = two_region_mesh();
  mesh.edges.push_back({.a = 3, .b = 4, .left = 0, .right = 0, .tag = 1, .loop = 0});
  mesh.tagged_points.push_back({2, 0});
  mesh.regions = {names[0], names[1]};
  mesh.tags = {names[2], names[3], names[4]};
  return mesh;
}

}  // namespace

TEST_CASE("every edge finds the side of a face, the left one first") {
  const OutputMesh mesh = two_region_mesh();
  const auto sides = edge_sides(mesh);
  REQUIRE(sides.size() == mesh.edges.size());
  for (std::size_t e = 0; e < sides.size(); ++e) {
    const OutputEdge& edge = mesh.edges[e];
    REQUIRE(sides[e].face != none);
    const Face& face = mesh.faces[static_cast<std::size_t>(sides[e].face)];
    const int next = (sides[e].side + 1) % corner_count(face);
    CHECK(face[static_cast<std::size_t>(sides[e].side)] == edge.a);
    CHECK(face[static_cast<std::size_t>(next)] == edge.b);
    CHECK(mesh.region[static_cast<std::size_t>(sides[e].face)] == edge.left);
  }
  OutputMesh turned = mesh;
  for (OutputEdge& edge : turned.edges) std::swap(edge.a, edge.b);
  for (const EdgeSide& side : edge_sides(turned)) CHECK(side.face != none);
  turned.faces.clear();
  for (const EdgeSide& side : edge_sides(turned)) CHECK(side.face == none);
}

TEST_CASE("INP has sets for regions, edges and points, and surfaces") {
  const std::string text = write_inp(two_region_mesh());
  CHECK(has(text,
            "*ELEMENT, TYPE=CPS4\n1, 1, 2, 5, 4\n*ELEMENT, TYPE=CPS3\n2, 4, 5, 7\n"
            "*ELSET, ELSET=steel__A36_____co_, GENERATE\n1, 2, 1\n"));
  CHECK(has(text, "*ELSET, ELSET=air, GENERATE\n3, 4, 1\n"));
  CHECK(has(text, "*NSET, NSET=inlet\n1, 4, 7\n"));
  CHECK(has(text, "*NSET, NSET=wall\n3, 6, 8\n"));
  CHECK(has(text, "*NSET, NSET=probe\n7\n"));
  CHECK(has(text, "*SURFACE, NAME=inlet, TYPE=ELEMENT\n2, S3\n1, S4\n"));
  CHECK(has(text, "*SURFACE, NAME=wall, TYPE=ELEMENT\n3, S2\n4, S2\n"));
  CHECK(has(text, "\n2, 0.33333333333333331, 0.0\n"));
}

TEST_CASE("INP elements are of the kind asked for, and shells have z and no surface") {
  const OutputMesh mesh = two_region_mesh();
  CHECK(has(write_inp(mesh, InpElement::cpe4), "TYPE=CPE4\n"));
  CHECK(has(write_inp(mesh, InpElement::cpe4), "TYPE=CPE3\n"));
  CHECK(has(write_inp(mesh, InpElement::cax4), "TYPE=CAX3\n"));
  const std::string shell = write_inp(mesh, InpElement::s4);
  CHECK(has(shell, "TYPE=S3\n"));
  CHECK(has(shell, "\n1, 0.0, 0.0, 0.0\n"));
  CHECK_FALSE(has(shell, "*SURFACE"));
}

TEST_CASE("regions of one name are one group in every format") {
  OutputMesh mesh = thrice_named_mesh();
  const std::string inp = write_inp(mesh);
  CHECK(count_starts(inp, "*ELSET") == 2);
  CHECK(has(inp, "*ELSET, ELSET=A, GENERATE\n1, 6, 1\n"));
  CHECK(has(inp, "*ELSET, ELSET=B, GENERATE\n7, 9, 1\n"));
  const std::string bdf = write_bdf(mesh);
  CHECK(has(bdf, "$ PID 1 = region \"A\"\n$ PID 2 = region \"B\"\n$ PID 3 = edges"));
  CHECK(count_starts(bdf, "CQUAD4         1       1") == 1);
  CHECK(count_starts(bdf, "CQUAD4         3       1") == 1);
  const std::string ply = write_ply(mesh);
  CHECK(count_starts(ply, "comment region") == 2);
  CHECK(count_starts(ply, "4 ") == 9);
  const auto ends = [](const std::string& text, const std::string& end) {
    const auto all = lines(text);
    return std::count_if(all.begin(), all.end(), [&](const std::string& line) {
      return line.rfind("4 ", 0) == 0 && line.substr(line.size() - end.size()) == end;
    });
  };
  CHECK(ends(ply, " 0") == 6);
  CHECK(ends(ply, " 1") == 3);
  CHECK(has(write_vtk(mesh), "region_names 1 4 unsigned_char\n65 0\n66 0\n"));

  mesh.regions = {"", "B", ""};  // what has no name shares none
  CHECK(count_starts(write_inp(mesh), "*ELSET") == 3);
}

TEST_CASE("INP lines have at most 16 entries") {
  for (const std::string& line : lines(write_inp(grid_mesh(30)))) {
    if (line[0] != '*') CHECK(std::count(line.begin(), line.end(), ',') < 16);
  }
}

TEST_CASE("a point and an edge of one name share a node set") {
  OutputMesh mesh = two_region_mesh();
  mesh.tagged_points = {{1, 2}};
  const std::string text = write_inp(mesh);
  CHECK(has(text, "*NSET, NSET=wall\n2, 3, 6, 8\n"));
  CHECK(count_starts(text, "*NSET, NSET=wall") == 1);
}

TEST_CASE("SU2 marks the boundary once, and tagged edges inside") {
  const std::string plain = write_su2(two_region_mesh());
  CHECK(
      has(plain, "NDIME= 2\nNELEM= 4\n9 0 1 4 3 0\n5 3 4 6 1\n9 1 2 5 4 2\n5 4 5 7 3\nNPOIN= 8\n"));
  CHECK(has(plain, "\nNMARK= 4\n"));
  CHECK(count_starts(plain, "3 ") == 8);  // not the border between the regions
  CHECK(has(plain, "MARKER_TAG= inlet\nMARKER_ELEMS= 2\n3 6 3\n3 3 0\n"));
  const std::string more = write_su2(named_mesh({"a", "b", "inlet", "crack", "wall"}));
  CHECK(has(more, "\nNMARK= 5\n"));
  CHECK(has(more, "MARKER_TAG= crack\nMARKER_ELEMS= 1\n3 3 4\n"));
}

TEST_CASE("one name on the boundary and inside makes two SU2 markers") {
  OutputMesh mesh = named_mesh({"a", "b", "wall", "x", "y"});
  mesh.edges.back().tag = 0;
  const std::string text = write_su2(mesh);
  CHECK(has(text, "MARKER_TAG= wall\nMARKER_ELEMS= 2\n"));
  CHECK(has(text, "MARKER_TAG= wall_2\nMARKER_ELEMS= 1\n3 3 4\n"));
}

TEST_CASE("BDF lines are columns") {
  const std::string text = write_bdf(two_region_mesh());
  for (const std::string& line : lines(text)) CHECK(line.size() <= 80);
  CHECK(has(text,
            "GRID*                  2                .333333333333333             0.0\n"
            "*                    0.0\n"));
  CHECK(has(text, "\nCQUAD4         1       1       1       2       5       4\n"));
  CHECK(has(text, "\nCTRIA3         4       2       5       6       8\n"));
  CHECK(count_starts(text, "CROD    ") == 9);
  CHECK(has(text, "\nSET1           1       7\n"));
  CHECK(has(text, "$ PID 1 = region \"steel 'A36' & <co>\"\n"));
  CHECK(has(text, "edges \"wall\"\n"));
}

TEST_CASE("BDF entries hold large integers and go on on further lines") {
  std::string text;
  append_bdf_entry(text, "CTRIA3", {99'999'999, 1, 12'345'678, 87'654'321, 3});
  CHECK(text == "CTRIA3  99999999       11234567887654321       3\n");
  text.clear();
  append_bdf_entry(text, "CQUAD4", {100'000'000, 1, 2, 3, 4, 5});
  CHECK(text ==
        "CQUAD4*        100000000               1               2               3\n"
        "*                      4               5\n");
  text.clear();
  append_bdf_entry(text, "SET1", {1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(lines(text).size() == 2);
  CHECK(lines(text)[1] == "+              9");
}

TEST_CASE("PLY has quads, then triangles, with their regions") {
  const std::string text = write_ply(two_region_mesh());
  CHECK(has(text, "element vertex 8\n"));
  CHECK(has(text, "element face 4\nproperty list uchar int vertex_indices\n"));
  CHECK(has(text, "\n4 0 1 4 3 0\n4 1 2 5 4 1\n3 3 4 6 0\n3 4 5 7 1\n"));
}

TEST_CASE("legacy VTK counts its cells") {
  const std::string text = write_vtk(two_region_mesh());
  CHECK(has(text, "POINTS 8 double\n"));
  CHECK(has(text, "\nCELLS 14 47\n4 0 1 4 3\n"));  // 2 quads, 2 triangles, 9 lines, 1 vertex
  CHECK(has(text, "\nCELL_TYPES 14\n9\n9\n5\n5\n3\n"));
  CHECK(has(text, "\nCELL_DATA 14\n"));
  CHECK(has(text, "\nregion 1 14 int\n0\n1\n0\n1\n"));
}

TEST_CASE("GeoJSON closes its rings and joins the edges of a tag") {
  const std::string text = write_geojson(grid_mesh(2));
  CHECK(has(text,
            "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[0.5,0],[0.5,0.5],[0,0.5],[0,0]]]}"));
  CHECK(has(text, "[[0,0],[0.5,0],[1,0],[1,0.5],[1,1],[0.5,1],[0,1],[0,0.5],[0,0]]"));
  CHECK(has(text, "\"properties\":{\"region\":null,\"eta\":1}"));
  const std::string tagged = write_geojson(two_region_mesh());
  CHECK(has(tagged, "\"properties\":{\"tag\":\"wall\",\"left\":\"air\",\"right\":null}"));
  CHECK(has(tagged,
            "\"type\":\"Point\",\"coordinates\":[0,0.25]},\"properties\":{\"tag\":\"probe\"}"));
}

TEST_CASE("regions of different names stay apart in OBJ and MSH") {
  OutputMesh mesh = thrice_named_mesh();
  const std::string long_name(127, 'x');
  for (const std::vector<std::string>& names : {std::vector<std::string>{"#1", "#2", "#3"},
                                                {"a b", "a_b", "a\tb"},
                                                {"a\"b", "a'b", "A"},
                                                {long_name + "1", long_name + "2", "c"},
                                                {"", "region 1", "region_1"}}) {
    mesh.regions = names;
    INFO(names[0].substr(0, 20));
    const auto obj = read_obj(write_obj(mesh));
    REQUIRE(obj.has_value());
    CHECK(std::set<std::string>(obj->regions.begin(), obj->regions.end()).size() == 3);
    for (const MshVersion version : {MshVersion::v4_1, MshVersion::v2_2}) {
      const auto msh = read_msh(write_msh(mesh, version));
      REQUIRE(msh.has_value());
      CHECK(std::set<std::string>(msh->regions.begin(), msh->regions.end()).size() == 3);
    }
  }
}

TEST_CASE("no name adds a line to a file or takes one away") {
  const OutputMesh plain = named_mesh({"a", "b", "c", "d", "e"});
  const std::string long_name(5000, '"');
  const std::vector<std::vector<std::string>> hostile{
      {"\"", "'", "\\", "]]>", "--"},
      {"\n", "\r\n", "\t", std::string(1, '\0'), "\x7F"},
      {"<script>", "&amp;", "$EndPhysicalNames", "*NODE", "ENDDATA"},
      {"end_header", "CELL_DATA 5", "MARKER_TAG= x", "NMARK= 1", "a,b"},
      {"\xFF", "\xC3", "\xE9\x8B\xBC", "\xF0\x9F\x98\x80", ""},
      {long_name, long_name + "a", long_name + "b", long_name + "c", long_name + "\n"},
      {"same", "Same", "sAME", "SAME", "same "}};
  for (const MeshFormatInfo& info : mesh_formats) {
    for (const auto& names : hostile) {
      INFO(info.name << " " << names[0].substr(0, 20));
      const std::string text = write_mesh(named_mesh(names), info.format);
      if (info.format != MeshFormat::svg) {
        CHECK(lines(text).size() == lines(write_mesh(plain, info.format)).size());
      }
      CHECK(text.find('\r') == std::string::npos);
      CHECK(text.find('\0') == std::string::npos);
    }
  }
}

TEST_CASE("every format is written twice alike") {
  const OutputMesh mesh = named_mesh({"a", "", "inlet", "crack", "wall"});
  for (const MeshFormatInfo& info : mesh_formats)
    CHECK(write_mesh(mesh, info.format) == write_mesh(mesh, info.format));
}

TEST_CASE("a mesh with heights has them in every format that can hold them") {
  OutputMesh mesh = named_mesh({"a", "b", "c", "d", "e"});
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    mesh.z.push_back(3.25 + 0.5 * static_cast<double>(v));
  for (const MeshFormatInfo& info : mesh_formats) {
    INFO(info.name);
    CHECK(is_shell_format(info.format) == info.in_space);
    if (!info.in_space) continue;
    const std::string text = write_mesh(mesh, info.format);
    for (const char* height : {"3.25", "3.75", "6.75"}) CHECK(has(text, height));
    CHECK(shell_endings().find(std::string(info.endings.substr(0, 4))) != std::string::npos);
  }
  CHECK_FALSE(is_shell_format(MeshFormat::su2));
  CHECK_FALSE(is_shell_format(MeshFormat::svg));
  CHECK(has(write_msh(mesh, MshVersion::v2_2), " 3.75\n"));
  CHECK(has(write_inp(mesh, InpElement::cps4), "TYPE=S4"));
}

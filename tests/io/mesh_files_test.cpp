// Writers read back by our readers, and the details that other programs trip on.
#include <algorithm>
#include <cstring>

#include "catch.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_json.h"
#include "io/mesh/msh_model.h"
#include "io/mesh/obj.h"
#include "io/mesh/vtu.h"
#include "support/output_meshes.h"

using namespace lpq;
using lpq_test::grid_mesh;
using lpq_test::thrice_named_mesh;
using lpq_test::two_region_mesh;

namespace {

bool same_bits(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

/// Faces with the name of their region, in a canonical order.
std::vector<std::pair<std::string, Face>> named_faces(const OutputMesh& mesh) {
  std::vector<std::pair<std::string, Face>> list;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    list.emplace_back(mesh.regions[static_cast<std::size_t>(mesh.region[f])], mesh.faces[f]);
  std::sort(list.begin(), list.end());
  return list;
}

std::string name_of(const OutputMesh& mesh, Index tag) {
  return tag == none ? "" : mesh.tags[static_cast<std::size_t>(tag)];
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("OBJ gives points bit for bit and faces in order") {
  const OutputMesh mesh = two_region_mesh();
  const auto back = read_obj(write_obj(mesh));
  REQUIRE(back.has_value());
  CHECK(same_bits(back->points, mesh.points));
  CHECK(back->faces == mesh.faces);
  CHECK(back->region == mesh.region);
  CHECK(back->regions == std::vector<std::string>{"steel_\"A36\"_&_<co>", "air"});
}

TEST_CASE("MSH gives points, faces, regions, tagged edges and points back") {
  const OutputMesh mesh = two_region_mesh();
  for (const MshVersion version : {MshVersion::v2_2, MshVersion::v4_1}) {
    const std::string text = write_msh(mesh, version);
    const auto back = read_msh(text);
    REQUIRE(back.has_value());
    CHECK(same_bits(back->points, mesh.points));
    OutputMesh renamed = mesh;
    renamed.regions[0] = "steel 'A36' & <co>";
    CHECK(named_faces(*back) == named_faces(renamed));
    REQUIRE(back->edges.size() == mesh.edges.size());
    for (const OutputEdge& edge : mesh.edges) {
      const auto found =
          std::find_if(back->edges.begin(), back->edges.end(),
                       [&](const auto& other) { return other.a == edge.a && other.b == edge.b; });
      REQUIRE(found != back->edges.end());
      const std::string tag = name_of(*back, found->tag);
      if (edge.tag != none) CHECK(tag == name_of(mesh, edge.tag));
      if (edge.tag == none) CHECK(tag.find("loop 1") != std::string::npos);
    }
    REQUIRE(back->tagged_points.size() == 1);
    CHECK(back->tagged_points[0].point == 6);
    CHECK(name_of(*back, back->tagged_points[0].tag) == "probe");
  }
}

TEST_CASE("regions of one name come back as one") {
  const OutputMesh mesh = thrice_named_mesh();
  const std::vector<std::string> names{"A", "B"};
  for (const MshVersion version : {MshVersion::v2_2, MshVersion::v4_1}) {
    const std::string text = write_msh(mesh, version);
    CHECK(count(text, "\"A\"") == 1);
    const auto back = read_msh(text);
    REQUIRE(back.has_value());
    CHECK(back->regions == names);
    CHECK(named_faces(*back) == named_faces(mesh));
  }
  const auto back = read_obj(write_obj(mesh));
  REQUIRE(back.has_value());
  CHECK(back->regions == names);
  CHECK(named_faces(*back) == named_faces(mesh));
}

TEST_CASE("MSH 4.1 follows the format: entities, blocks, tag ranges") {
  const OutputMesh mesh = two_region_mesh();
  const std::string text = write_msh(mesh, MshVersion::v4_1);
  CHECK(text.rfind("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n", 0) == 0);
  // 1 tagged point; curves: bottom, bottom 2, wall, back, top, inlet, border = by region, tag,
  // sides
  const MshModel model = make_msh_model(mesh);
  CHECK(model.curves.size() == 5);
  CHECK(text.find("\n$Entities\n1 5 2 0\n") != std::string::npos);
  CHECK(text.find("$Nodes\n") != std::string::npos);
  CHECK(text.find(" 8 1 8\n") != std::string::npos);    // all nodes, tags 1 .. 8
  CHECK(text.find(" 14 1 14\n") != std::string::npos);  // 1 point, 9 lines, 4 faces
  CHECK(count(text, "$End") == 5);
}

TEST_CASE("MSH nodes belong to the entity of lowest dimension") {
  const OutputMesh mesh = grid_mesh(3);
  const MshModel model = make_msh_model(mesh);
  CHECK(model.curves.size() == 1);
  CHECK(std::count(model.node_dimension.begin(), model.node_dimension.end(), 1) == 12);
  CHECK(std::count(model.node_dimension.begin(), model.node_dimension.end(), 2) == 4);
  CHECK(model.surface_names == std::vector<std::string>{"domain"});
  CHECK(model.curve_names == std::vector<std::string>{"loop 1"});
}

TEST_CASE("an untagged polyline has a name of its own, not that of a loop") {
  OutputMesh mesh = two_region_mesh();
  mesh.edges.push_back({.a = 3, .b = 4, .left = 0, .right = 0, .loop = 1, .edge = 0});
  CHECK(make_msh_model(mesh).curve_names.back() == "polyline 2");
}

TEST_CASE("VTU counts cells, offsets and types alike") {
  const OutputMesh mesh = two_region_mesh();
  const std::string text = write_vtu(mesh);
  CHECK(text.find("NumberOfPoints=\"8\" NumberOfCells=\"14\"") != std::string::npos);
  CHECK(text.find("<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n9\n9\n5\n5\n3\n") !=
        std::string::npos);
  CHECK(text.find("4\n8\n11\n14\n16\n18\n") != std::string::npos);
  CHECK(count(text, "<DataArray") == count(text, "</DataArray>"));
  CHECK(text.find("115 116 101 101 108 32") != std::string::npos);  // "steel "
}

TEST_CASE("JSON meshes hold every array") {
  const std::string text = write_mesh_json(two_region_mesh());
  CHECK(text.find("\"quads\":[[0,1,4,3],[1,2,5,4]],") != std::string::npos);
  CHECK(text.find("\"triangleRegion\":[0,1],") != std::string::npos);
  CHECK(text.find("\"edgeTag\":[-1,-1,2,2,-1,-1,0,0,-1],") != std::string::npos);
  CHECK(text.find("\"regions\":[\"steel \\\"A36\\\" & <co>\",\"air\"]") != std::string::npos);
}

TEST_CASE("formats are known by their endings") {
  CHECK(mesh_format("a/b.OBJ") == MeshFormat::obj);
  CHECK(mesh_format("x.msh") == MeshFormat::msh);
  CHECK(mesh_format("x.json") == MeshFormat::json);
  CHECK(mesh_format("x.geojson") == MeshFormat::geojson);
  CHECK(mesh_format("x.NAS") == MeshFormat::bdf);
  CHECK_FALSE(mesh_format("msh").has_value());
  CHECK_FALSE(mesh_format("x.obj.txt").has_value());
  const auto refused = read_mesh("", MeshFormat::vtu);
  CHECK_FALSE(refused.has_value());
}

TEST_CASE("the table of formats has every format once, with names and endings of its own") {
  for (std::size_t i = 0; i < mesh_formats.size(); ++i) {
    const MeshFormatInfo& info = mesh_formats[i];
    CHECK(info.format == static_cast<MeshFormat>(i));
    CHECK(mesh_format_by_name(info.name) == info.format);
    CHECK(mesh_format("x." + std::string(info.name)) == info.format);
    CHECK(mesh_endings().find(info.endings.substr(0, info.endings.find(' '))) != std::string::npos);
  }
  CHECK_FALSE(mesh_format_by_name("").has_value());
  CHECK_FALSE(mesh_format_by_name("stl").has_value());
  CHECK(mesh_endings().rfind(".obj, .msh, ", 0) == 0);
  CHECK(mesh_endings().find(".svg or .json") != std::string::npos);
}

TEST_CASE("an empty mesh is written without a fault") {
  const OutputMesh empty;
  for (const MeshFormatInfo& info : mesh_formats)
    CHECK_FALSE(write_mesh(empty, info.format).empty());
  CHECK_FALSE(write_mesh(empty, MeshFormat::msh, {MshVersion::v2_2}).empty());
}

TEST_CASE("a large mesh is written in linear time") {
  const OutputMesh mesh = grid_mesh(300);
  for (const MshVersion version : {MshVersion::v2_2, MshVersion::v4_1}) {
    const auto back = read_msh(write_msh(mesh, version));
    REQUIRE(back.has_value());
    CHECK(back->faces == mesh.faces);
  }
}

// Readers against files that are not what they say they are.
#include "base/rng.h"
#include "catch.h"
#include "io/mesh/msh.h"
#include "io/mesh/obj.h"
#include "support/output_meshes.h"

using namespace lpq;
using lpq_test::two_region_mesh;

namespace {

const std::string good_msh_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n9 0 1 "
    "0\n$EndNodes\n"
    "$Elements\n2\n1 1 2 7 1 1 2\n2 3 2 5 1 1 2 3 9\n$EndElements\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void require_refused(const Result<OutputMesh>& result) {
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().code == ErrorCode::parse_error);
  CHECK_FALSE(result.error().message.empty());
  CHECK(result.error().where.line >= 0);
  CHECK(result.error().where.byte >= 0);
}

}  // namespace

TEST_CASE("OBJ as other programs write it") {
  const auto mesh = read_obj(
      "\xEF\xBB\xBF# comment\r\nmtllib a.mtl\r\nv 0 0 0\r\nv\t1  0\r\nv 1 1 0 # corner\r\nv 0 1 "
      "0\r\n"
      "v 5 5 0\r\nvt 0 0\r\nvn 0 0 1\r\ns off\r\nf 1/1/1 2/1/1 3//1 -2\r\nf 1 2 3\r\n");
  REQUIRE(mesh.has_value());
  CHECK(mesh->points.size() == 4);  // the unused vertex is dropped
  CHECK(mesh->faces == std::vector<Face>{{0, 1, 2, 3}, {0, 1, 2, none}});
}

TEST_CASE("OBJ is read as the surface reader does: lines that go on, names, later vertices") {
  const auto mesh = read_obj(
      "# C:\\a\\\ng top side\nf 1 2 \\\n3 4\ng top #2\nf 2 5 6 \\ \n3\n"
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n");
  INFO((mesh ? std::string() : mesh.error().message));
  REQUIRE(mesh.has_value());
  CHECK(mesh->faces == std::vector<Face>{{0, 1, 2, 3}, {1, 4, 5, 2}});
  CHECK(mesh->regions == std::vector<std::string>{"top side", "top #2"});
  CHECK(read_obj("f 1 2 3\nf 1 2 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\n").error().where.line == 2);
}

TEST_CASE("a mesh may have a group for each of very many faces") {
  const int count = 30'000;
  std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  std::string msh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
      "3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n" +
      std::to_string(count) + "\n";
  for (int i = 1; i <= count; ++i) {
    obj += "g face_" + std::to_string(i % 20'000) + "\nf 1 2 3 4\n";
    msh += std::to_string(i) + " 3 2 " + std::to_string(i) + " 1 1 2 3 4\n";
  }
  const auto from_obj = read_obj(obj), from_msh = read_msh(msh + "$EndElements\n");
  REQUIRE(from_obj.has_value());
  CHECK(from_obj->regions.size() == 20'000);
  CHECK(from_obj->region[25'000] == from_obj->region[5'000]);
  REQUIRE(from_msh.has_value());
  CHECK(from_msh->regions.size() == count);
}

TEST_CASE("malformed OBJ is refused with its line") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  for (const char* line : {"f 1 2 4", "f 0 1 2", "f 1 2", "f 1 2 3 1 2", "f 1 2 x", "f 1 2 -4",
                           "f 1 2 99999999999999999999", "f 1 2 2147483649", "v 1", "v nan 0 0",
                           "v 1e999 0 0", "v 0 0 1", "f 1.0 2 3"}) {
    INFO(line);
    const auto result = read_obj(points + line + "\n");
    require_refused(result);
    CHECK(result.error().where.line == 4);
    CHECK(result.error().where.byte == static_cast<std::int64_t>(points.size()));
  }
  require_refused(read_obj(""));
  require_refused(read_obj(points));
}

TEST_CASE("MSH 2.2 as Gmsh writes it") {
  const auto mesh = read_msh(good_msh_2);
  REQUIRE(mesh.has_value());
  CHECK(mesh->points.size() == 4);
  CHECK(mesh->faces == std::vector<Face>{{0, 1, 2, 3}});
  CHECK(mesh->edges.size() == 1);
  const auto with_more =
      read_msh(replaced(good_msh_2, "$Nodes", "$Comments\n$$ what \"ever\"\n$EndComments\n$Nodes"));
  CHECK(with_more.has_value());
  CHECK(read_msh("$Comments\n2.2\n$EndComments\n" + good_msh_2).has_value());
}

TEST_CASE("malformed MSH is refused") {
  const std::pair<const char*, const char*> changes[] = {
      {"2.2 0 8", "3.0 0 8"},
      {"2.2 0 8", "2.2 1 8"},
      {"2.2 0 8", "x 0 8"},
      {"2.2 0 8", "4.0 0 8"},
      {"$Nodes\n4", "$Nodes\n5"},
      {"$Nodes\n4", "$Nodes\n3"},
      {"$Nodes\n4", "$Nodes\n4000000000"},
      {"$Nodes\n4", "$Nodes\n-1"},
      {"9 0 1 0", "1 0 1 0"},
      {"9 0 1 0", "9 0 1 0.5"},
      {"9 0 1 0", "9 0 inf 0"},
      {"1 2 3 9", "1 2 3 8"},
      {"1 2 3 9", "1 2 3"},
      {"2 3 2 5 1", "2 16 2 5 1"},
      {"2 3 2 5 1", "2 3 -1 5 1"},
      {"2 3 2 5 1", "2 3 99 5 1"},
      {"$EndNodes", "$EndNode"},
      {"$MeshFormat", "$Nodes"},
      {"$Elements\n2", "$Elements\n99999999999999"},
      {"2 3 2 5 1", "2 3 2 -9223372036854775808 1"}};
  for (const auto& [from, to] : changes) {
    INFO(from << " -> " << to);
    require_refused(read_msh(replaced(good_msh_2, from, to)));
  }
  require_refused(read_msh(""));
  require_refused(read_msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"));
}

TEST_CASE("a mesh file cut anywhere is refused or complete") {
  const OutputMesh mesh = two_region_mesh();
  const std::string files[] = {write_msh(mesh, MshVersion::v2_2),
                               write_msh(mesh, MshVersion::v4_1)};
  for (const std::string& text : files) {
    for (std::size_t length = 0; length < text.size(); ++length) {
      const auto cut = read_msh(std::string_view(text).substr(0, length));
      if (length + 1 < text.size()) {
        INFO(length);
        require_refused(cut);
      } else {
        CHECK(cut.has_value());  // only the last line end is missing
      }
    }
  }
  const std::string obj = write_obj(mesh);
  for (std::size_t length = 0; length < obj.size(); ++length) {
    const auto cut = read_obj(std::string_view(obj).substr(0, length));
    if (cut) CHECK(cut->faces.size() <= mesh.faces.size());
  }
}

TEST_CASE("random damage never makes a mesh with wrong indices") {
  Rng rng(11);
  const OutputMesh mesh = two_region_mesh();
  const std::string files[] = {write_msh(mesh, MshVersion::v2_2), write_msh(mesh, MshVersion::v4_1),
                               write_obj(mesh)};
  for (const std::string& text : files) {
    for (int round = 0; round < 3000; ++round) {
      std::string damaged = text;
      for (std::uint64_t k = 1 + rng.below(3); k > 0; --k) {
        const std::size_t at = rng.below(damaged.size());
        constexpr std::string_view pieces = "0123456789-+.e $\"\n\xFF";
        damaged[at] = pieces[rng.below(pieces.size())];
      }
      const auto result = &text == &files[2] ? read_obj(damaged) : read_msh(damaged);
      if (!result) continue;
      for (const Face& face : result->faces)
        for (int k = 0; k < corner_count(face); ++k)
          REQUIRE((face[k] >= 0 && face[k] < static_cast<Index>(result->points.size())));
      for (const Index r : result->region)
        REQUIRE((r >= 0 && r < static_cast<Index>(result->regions.size())));
      for (const OutputEdge& edge : result->edges)
        REQUIRE((edge.a >= 0 && edge.b >= 0 && edge.tag < static_cast<Index>(result->tags.size())));
    }
  }
}

TEST_CASE("a line of a million characters is read once") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n# ";
  text.append(1'000'000, 'x');
  CHECK(read_obj(text).has_value());
  require_refused(read_obj("f" + std::string(1'000'000, ' ') + "1"));
  std::string words = "v";
  for (int i = 0; i < 500'000; ++i) words += " 1";
  require_refused(read_obj(words));
}

// Binary MSH files, and version 4.0: what their texts are, and nothing worse when damaged.
#include "support/msh_bytes.h"

#include <cstring>
#include <limits>

#include "base/rng.h"
#include "catch.h"
#include "io/domain/domain_format.h"
#include "io/mesh/msh.h"
#include "io/surface/msh_surface.h"
#include "io/surface/surface_format.h"
#include "support/output_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// Two triangles of a named plate, one side named, as Gmsh 4.0 wrote it: tag before dimension, a
/// box for a point, too, and a node in one row.
const std::string text_4_0 =
    "$MeshFormat\n4 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 3 \"low\"\n2 7 \"plate\"\n"
    "$EndPhysicalNames\n$Entities\n1 1 1 0\n1 0 0 0 0 0 0 0 \n5 0 0 0 1 0 0 2 3 -4 2 1 -2 \n"
    "6 0 0 0 1 1 0 1 7 1 5 \n$EndEntities\n$Nodes\n2 4\n5 1 1 2\n1 0 0 0 0\n2 1 0 0 1\n"
    "6 2 0 2\n30 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n2 3\n5 1 1 1\n1 1 2\n6 2 2 2\n"
    "2 1 2 30\n3 1 30 4\n$EndElements\n";

/// A tetrahedron between a triangle of second and one of third order, and a quad.
const std::string text_in_space =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n6\n1 0 0 0 0 4\n2 1 0 0 1 4 .5\n"
    "3 0 1 2 2 4 .5 .5\n4 .5 0 0 2 4 1 1\n5 .5 .5 1 2 4 1 1\n6 0 .5 1 2 4 1 1\n"
    "$EndParametricNodes\n$Elements\n5\n1 9 2 0 3 1 2 3 4 5 6\n2 4 2 0 1 1 2 3 4\n"
    "3 21 2 0 3 1 2 3 4 5 6 1 2 3 4\n4 15 2 0 3 1\n5 3 2 0 8 1 2 3 6\n$EndElements\n";

std::vector<std::string> plane_texts() {
  const OutputMesh mesh = two_region_mesh();
  return {write_msh(mesh, MshVersion::v2_2), write_msh(mesh, MshVersion::v4_1), text_4_0};
}

/// Every way to write a text as bytes.
std::vector<std::string> all_bytes(const std::string& text) {
  std::vector<std::string> all{msh_bytes(text), msh_bytes(text, true)};
  if (text.find("\n4.1 0 8\n") != std::string::npos) all.push_back(msh_bytes(text, true, 4));
  return all;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

OutputMesh good(const Result<OutputMesh>& mesh) {
  INFO((mesh ? std::string() : mesh.error().message));
  REQUIRE(mesh.has_value());
  return *mesh;
}

Error refused(const std::string& bytes) {
  const auto mesh = read_msh(bytes, MeshScope::space);
  REQUIRE_FALSE(mesh.has_value());
  CHECK(mesh.error().code == ErrorCode::parse_error);
  CHECK(mesh.error().where.byte >= 0);
  return mesh.error();
}

/// The file with bytes of its own behind `word`, `skipped` bytes on.
std::string patched(std::string bytes, const std::string& word, std::size_t skipped,
                    const std::string& patch) {
  const std::size_t at = bytes.find(word);
  REQUIRE(at != std::string::npos);
  return bytes.replace(at + word.size() + skipped, patch.size(), patch);
}

std::string number(std::uint64_t value, std::size_t size) {
  std::string bytes;
  for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xff);
  return bytes;
}

}  // namespace

TEST_CASE("MSH 4.0 is read with its names") {
  const OutputMesh mesh = good(read_msh(text_4_0));
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 3, none}, {0, 3, 2, none}});
  CHECK(mesh.points[3] == Vec2{1, 1});
  CHECK(mesh.regions == std::vector<std::string>{"plate"});
  REQUIRE(mesh.edges.size() == 1);
  CHECK(mesh.tags[static_cast<std::size_t>(mesh.edges[0].tag)] == "low");
}

TEST_CASE("binary MSH of every version and byte order is its text") {
  for (const std::string& text : plane_texts()) {
    const OutputMesh expected = good(read_msh(text));
    for (const std::string& bytes : all_bytes(text)) {
      const OutputMesh mesh = good(read_msh(bytes));
      CHECK(same_bits(mesh.points, expected.points));
      CHECK(mesh.faces == expected.faces);
      CHECK(mesh.region == expected.region);
      CHECK(mesh.regions == expected.regions);
      CHECK(mesh.tags == expected.tags);
      REQUIRE(mesh.edges.size() == expected.edges.size());
      for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        CHECK(mesh.edges[e].a == expected.edges[e].a);
        CHECK(mesh.edges[e].tag == expected.edges[e].tag);
      }
      CHECK(mesh.tagged_points.size() == expected.tagged_points.size());
    }
  }
}

TEST_CASE("binary MSH as a domain and as a surface is its text") {
  for (const std::string& text : plane_texts())
    for (const std::string& bytes : all_bytes(text)) {
      CHECK_FALSE(is_surface_file("a.msh", bytes));
      const auto expected = read_domain_file("a.msh", text), domain = read_domain_file("", bytes);
      REQUIRE(domain.has_value());
      REQUIRE(domain->domain.regions.size() == expected->domain.regions.size());
      for (std::size_t r = 0; r < domain->domain.regions.size(); ++r) {
        CHECK(domain->domain.regions[r].loops == expected->domain.regions[r].loops);
        CHECK(domain->domain.regions[r].tags == expected->domain.regions[r].tags);
      }
    }
  for (const std::string& text : {msh_text(box_soup({1, 2, 3}, 2)), text_in_space}) {
    const auto expected = read_surface_file("a.msh", text);
    REQUIRE(expected.has_value());
    for (const std::string& bytes : all_bytes(text)) {
      CHECK(is_surface_file("a.msh", bytes));
      const auto soup = read_surface_file("", bytes);
      REQUIRE(soup.has_value());
      CHECK(same_bits(soup->points, expected->points));
      CHECK(soup->triangles == expected->triangles);
      CHECK(soup->group_names == expected->group_names);
      CHECK(soup->warnings.size() == expected->warnings.size());
    }
  }
}

TEST_CASE("a binary MSH file cut anywhere is refused or complete") {
  for (const std::string& text : plane_texts())
    for (const std::string& bytes : all_bytes(text))
      for (std::size_t length = 0; length + 1 < bytes.size(); ++length) {
        INFO(length);
        (void)refused(bytes.substr(0, length));
      }
  const Error error = refused(msh_bytes(text_4_0).substr(0, 300));
  CHECK(error.message.find("cut off") != std::string::npos);
  CHECK(error.where.line == none);
}

TEST_CASE("counts of a binary MSH file that lie are refused") {
  const std::string old = msh_bytes(text_in_space), now = msh_bytes(plane_texts()[1]);
  for (const std::uint64_t count : {0ull, 2ull, 6ull, 0x7fffffffull, 0x80000000ull, 0xffffffffull})
    refused(patched(old, "$Elements\n5\n", 4, number(count, 4)));  // of elements in a batch
  for (const std::uint64_t tags : {1ull, 3ull, 0x7fffffffull, 0x80000000ull, 0xffffffffull})
    refused(patched(old, "$Elements\n5\n", 8, number(tags, 4)));
  for (const std::uint64_t type : {0ull, 2ull, 34ull, 94ull, 0x7fffffffull, 0xffffffffull})
    refused(patched(old, "$Elements\n5\n", 0, number(type, 4)));
  refused(patched(old, "$Elements\n", 0, "9"));
  refused(patched(old, "$ParametricNodes\n", 0, "9"));
  refused(patched(old, "$ParametricNodes\n6\n", 28, number(0x7fffffff, 4)));  // the dimension
  for (const std::uint64_t count :
       {1ull << 31, 1ull << 32, 1ull << 40, 1ull << 61, ~0ull >> 1, 1ull << 63, ~0ull}) {
    for (const char* section : {"$Entities\n", "$Nodes\n", "$Elements\n"})
      refused(patched(now, section, 0, number(count, 8)));
    refused(patched(now, "$Nodes\n", 32 + 12, number(count, 8)));  // of nodes in a block
    refused(patched(now, "$Elements\n", 32 + 12, number(count, 8)));
    refused(patched(now, "$Entities\n", 32 + 28, number(count, 8)));  // of physical tags
  }
}

TEST_CASE("what else is wrong with a binary MSH file is said") {
  const std::string old = msh_bytes(text_in_space);
  const auto message = [](const std::string& bytes) { return refused(bytes).message; };
  CHECK(message(patched(old, "2.2 1 8\n", 0, number(2, 4))).find("the number 1 in four bytes") !=
        std::string::npos);
  CHECK(message(patched(old, "2.2 ", 0, "2")).find("0 (ASCII) or 1 (binary)") != std::string::npos);
  CHECK(message(patched(old, "2.2 1 ", 0, "4")).find("data size 8") != std::string::npos);
  CHECK(message(patched(old, "$Elements\n5\n", 0, number(34, 4))).find("Element type 34") !=
        std::string::npos);
  std::string nan;
  append_double(nan, std::numeric_limits<double>::quiet_NaN());
  CHECK(message(patched(old, "$ParametricNodes\n6\n", 4, nan)).find("finite") != std::string::npos);
  CHECK(message(patched(old, "$ParametricNodes\n6\n", 0, number(2, 4))).find("Node 2 is") !=
        std::string::npos);
}

TEST_CASE("random damage to a binary MSH file never makes a mesh with wrong indices") {
  Rng rng(12);
  for (const std::string& text : plane_texts())
    for (const std::string& bytes : all_bytes(text))
      for (int round = 0; round < 2000; ++round) {
        std::string damaged = bytes;
        for (std::uint64_t k = 1 + rng.below(3); k > 0; --k)
          damaged[rng.below(damaged.size())] = static_cast<char>(rng.below(256));
        const auto result = read_msh(damaged, MeshScope::space);
        if (!result) continue;
        for (const Face& face : result->faces)
          for (int k = 0; k < corner_count(face); ++k)
            REQUIRE((face[k] >= 0 && face[k] < static_cast<Index>(result->points.size())));
        for (const OutputEdge& edge : result->edges)
          REQUIRE((edge.tag < static_cast<Index>(result->tags.size())));
      }
}

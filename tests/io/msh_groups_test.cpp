// Whose name an element of a .msh file has: parts of a partitioned mesh, and overlapping groups.
#include <algorithm>
#include <string>

#include "base/rng.h"
#include "catch.h"
#include "io/mesh/msh.h"
#include "io/surface/msh_surface.h"
#include "support/domain_files.h"
#include "support/msh_bytes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

const std::string names =
    "$PhysicalNames\n3\n1 3 \"low\"\n1 7 \"cut\"\n2 7 \"plate\"\n$EndPhysicalNames\n";

/// Two squares, which are two parts of a plate with a physical group or without. Between them is a
/// cut, with the tag of the plate's group.
std::string partitioned(bool old, bool grouped) {
  const std::string group = grouped ? " 1 7 " : " 0 ", low = grouped ? " 1 3 " : " 0 ";
  const std::string point = old ? " 1 0 0 1 0 0" : " 1 0 0", box = " 0 0 0 2 1 0";
  const std::string nodes[] = {"0 0 0", "1 0 0", "2 0 0", "0 1 0", "1 1 0", "2 1 0"};
  std::string text = std::string("$MeshFormat\n") + (old ? "4" : "4.1") + " 0 8\n$EndMeshFormat\n" +
                     names + "$Entities\n0 1 1 0\n5" + box + low + "2 1 -2\n1" + box + group +
                     "1 5\n$EndEntities\n$PartitionedEntities\n2\n1\n4 1\n1 3 2 0\n" +
                     "9 1 5 2 1 2" + point + low + "\n" +  //
                     "6 1 5 1 1" + box + low + "2 1 -9\n7 1 5 1 2" + box + low + "2 9 -2\n" +
                     "8 2 1 2 1 2" + box + group + "1 9\n" + "2 2 1 1 1" + box + group +
                     "2 6 8\n3 2 1 1 2" + box + group + "2 7 -8\n$EndPartitionedEntities\n";
  text += old ? "$Nodes\n1 6\n1 2 0 6\n" : "$Nodes\n1 6 1 6\n2 1 0 6\n";
  for (int i = 0; i < 6; ++i)
    text += std::to_string(i + 1) + (old ? ' ' + nodes[i] : std::string()) + '\n';
  for (int i = 0; i < 6 && !old; ++i) text += nodes[i] + '\n';
  text += std::string("$EndNodes\n$Elements\n") + (old ? "6 6\n" : "6 6 1 6\n");
  const auto block = [&](const char* dimension, const char* entity, const char* rest) {
    text += std::string(old ? entity : dimension) + ' ' + (old ? dimension : entity) + rest;
  };
  block("0", "9", " 15 1\n1 2\n");
  block("1", "6", " 1 1\n2 1 2\n");
  block("1", "7", " 1 1\n3 2 3\n");
  block("1", "8", " 1 1\n4 2 5\n");
  block("2", "2", " 3 1\n5 1 2 5 4\n");
  block("2", "3", " 3 1\n6 2 3 6 5\n");
  return text + "$EndElements\n";
}

/// Two squares in "left" and "right", and "all" of them, and a line in "low" and in group 9: in
/// version 2.2 an element for each of its groups, else entities with two groups.
std::string overlapping(bool old, const std::string& height) {
  const std::string box = " 0 0 0 2 1 0";
  const std::string nodes[] = {"0 0 ", "1 0 ", "2 0 ", "0 1 ", "1 1 ", "2 1 "};
  std::string text = std::string("$MeshFormat\n") + (old ? "2.2" : "4.1") +
                     " 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 3 \"low\"\n2 1 \"left\"\n"
                     "2 2 \"right\"\n2 4 \"all\"\n$EndPhysicalNames\n";
  if (!old)
    text += "$Entities\n0 1 2 0\n5" + box + " 2 3 9 0\n1" + box + " 2 1 4 0\n2" + box +
            " 2 2 4 0\n$EndEntities\n";
  text += old ? "$Nodes\n6\n" : "$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n";
  for (int i = 0; i < 6; ++i)
    text += (old ? std::to_string(i + 1) + ' ' : std::string()) + nodes[i] + height + '\n';
  text += "$EndNodes\n$Elements\n";
  text += old ? "6\n1 1 2 3 5 1 2\n2 1 2 9 5 2 1\n3 3 2 1 1 1 2 5 4\n4 3 2 2 2 2 3 6 5\n"
                "5 3 2 4 1 1 2 5 4\n6 3 2 4 2 5 2 3 6\n"
              : "3 3 1 3\n1 5 1 1\n1 1 2\n2 1 3 1\n2 1 2 5 4\n2 2 3 1\n3 2 3 6 5\n";
  return text + "$EndElements\n";
}

bool contains(const Warning& warning, const char* text) {
  return warning.message.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("parts of a partitioned mesh have the names of the whole, and no border between them") {
  for (const bool old : {false, true})
    for (const bool grouped : {false, true}) {
      const std::string text = partitioned(old, grouped);
      for (const std::string& bytes : {text, msh_bytes(text), msh_bytes(text, true)}) {
        INFO("version " << (old ? "4.0" : "4.1") << ", grouped " << grouped);
        const auto mesh = read_msh(bytes);
        REQUIRE(mesh.has_value());
        CHECK(mesh->regions == std::vector<std::string>{grouped ? "plate" : ""});
        CHECK(mesh->region == std::vector<Index>{0, 0});
        CHECK(mesh->edges.size() == 2);
        CHECK(mesh->tagged_points.empty());
        const DomainInput domain = read_file(bytes, DomainFormat::msh).domain;
        REQUIRE(domain.regions.size() == 1);
        CHECK(domain.regions[0].name == (grouped ? "plate" : ""));
        CHECK(domain.polylines.empty());
        CHECK(total_area(domain) == 2);
        const std::vector<std::string>& tags = domain.regions[0].tags.at(0);
        CHECK(std::count(tags.begin(), tags.end(), "low") == (grouped ? 2 : 0));
      }
    }
}

TEST_CASE("a partitioned MSH file that is cut or damaged is refused, or a mesh") {
  Rng rng(7);
  for (const bool old : {false, true}) {
    const std::string text = partitioned(old, true);
    for (const std::string& bytes : {text, msh_bytes(text)}) {
      for (std::size_t length = 0; length + 1 < bytes.size(); ++length)
        CHECK_FALSE(read_msh(bytes.substr(0, length)).has_value());
      for (int round = 0; round < 2000; ++round) {
        std::string damaged = bytes;
        damaged[rng.below(damaged.size())] = static_cast<char>(rng.below(256));
        const auto mesh = read_msh(damaged);
        if (!mesh) continue;
        for (const Face& face : mesh->faces)
          for (int k = 0; k < corner_count(face); ++k)
            CHECK(face[k] < static_cast<Index>(mesh->points.size()));
      }
    }
  }
}

TEST_CASE("of overlapping physical groups the first counts, which is told") {
  for (const bool old : {false, true}) {
    const DomainFile file = read_file(overlapping(old, "0"), DomainFormat::msh);
    REQUIRE(file.domain.regions.size() == 2);
    CHECK(file.domain.regions[0].name == "left");
    CHECK(file.domain.regions[1].name == "right");
    CHECK(total_area(file.domain) == 2);
    REQUIRE(file.warnings.size() == 1);
    CHECK(
        contains(file.warnings[0], "taken: 3. Nothing is left of \"physical curve 9\", \"all\"."));

    const auto soup = read_msh_surface(overlapping(old, "1"));
    REQUIRE(soup.has_value());
    CHECK(soup->triangles.size() == 4);
    CHECK(soup->group_names == std::vector<std::string>{"left", "right"});
    REQUIRE(soup->warnings.size() == 2);
    CHECK(contains(soup->warnings[0], "taken: 2. Nothing is left of \"all\"."));
    CHECK(contains(soup->warnings[1], "Physical curves were left out: \"low\"."));
  }
}

// GeoJSON, .poly and MSH as domains, and how the format of a file is found.
#include "support/domain_files.h"

#include "catch.h"
#include "io/mesh/msh.h"
#include "support/output_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainFile geojson(const std::string& text) {
  return lpq_test::read_file(text, DomainFormat::geojson);
}
std::string polygon(const std::string& rings) {
  return R"({"type": "Polygon", "coordinates": )" + rings + "}";
}
const std::string ring = "[[0,0],[4,0],[4,2],[0,2],[0,0]]";

const std::string poly_square = "6 2 0 1\n0 0 0 0\n1 4 0 0\n2 4 2 0\n3 0 2 0\n4 1 1 5\n5 9 9 0\n";

}  // namespace

TEST_CASE("every sample is the same plate, and its content says its format") {
  for (const auto& [format, text] : sample_domain_files()) {
    INFO(static_cast<int>(format) << ": " << text);
    const auto file = lpq_test::read_file(text, format);
    CHECK(domain_format_by_content(text) == format);
    CHECK(domain_format_by_content("\xEF\xBB\xBF\r\n" + text) == format);
    REQUIRE(file.domain.regions.size() == 1);
    CHECK(file.domain.regions[0].loops.size() == 2);
    CHECK(std::abs(total_area(file.domain) - 7) < 1e-12);
    CHECK(make_domain(file.domain).has_value());
    CHECK(read_domain_file("-", text).has_value());
    std::string crlf;
    for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    CHECK(total_area(lpq_test::read_file(crlf, format).domain) == total_area(file.domain));
  }
}

TEST_CASE("formats by name and ending") {
  CHECK(domain_format_by_ending("a/b.c/part.DXF") == DomainFormat::dxf);
  CHECK(domain_format_by_ending("x.GeoJson") == DomainFormat::geojson);
  CHECK_FALSE(domain_format_by_ending("dxf"));
  CHECK_FALSE(domain_format_by_ending(""));
  CHECK(domain_format_by_name("poly") == DomainFormat::poly);
  CHECK_FALSE(domain_format_by_name("stl"));
  CHECK_FALSE(domain_format_by_content(""));
  CHECK_FALSE(domain_format_by_content("solid cube"));
  CHECK(domain_format_by_content("999\nfrom a program\n  0\nSECTION\n") == DomainFormat::dxf);
  CHECK(domain_format_by_content("  0\r\nSECTION\r\n") == DomainFormat::dxf);
  CHECK(domain_format_by_content(R"({"loops": [], "type": "plate"})") == DomainFormat::json);
  CHECK(domain_format_by_content(R"({"loops": {"type": "Feature"}})") == DomainFormat::json);
  // GeoJSON under its other name.
  CHECK(read_domain_file("x.json", polygon("[" + ring + "]")).has_value());
  CHECK(read_domain_file("t1.geo", "lc = 1;").error().message.find("gmsh -1") != std::string::npos);
  CHECK(read_domain_file("x.stl", "solid x").error().code == ErrorCode::parse_error);
}

TEST_CASE("GeoJSON: every geometry, in any order of members") {
  const auto file = geojson(R"({"features": [
    {"geometry": {"coordinates": [[)" +
                            ring + R"(], [[[9,0],[10,0],[9,1],[9,0]]]], "type": "MultiPolygon"},
     "properties": {"name": "isle", "tag": 5}, "type": "Feature", "id": 7},
    {"type": "Feature", "properties": {"name": "wire", "tag": "cut"}, "geometry": {"type": "GeometryCollection",
     "geometries": [{"type": "MultiLineString", "coordinates": [[[1,1],[2,1]],[[3,1],[3,1.5,99]]]},
                    {"type": "MultiPoint", "coordinates": [[0.5,0.5],[0.6,0.5]]},
                    {"type": "Point", "coordinates": [0.7, 0.5, 100, 1]}]}},
    {"type": "Feature", "properties": null, "geometry": null},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": []}}],
    "type": "FeatureCollection", "bbox": [0, 0, 1, 1], "crs": {"type": "name", "properties": {"name": "x"}}})");
  REQUIRE(file.domain.regions.size() == 2);
  CHECK(file.domain.regions[0].name == "isle");
  CHECK(file.domain.regions[1].name == "isle");
  CHECK(total_area(file.domain) == 8.5);
  REQUIRE(file.domain.polylines.size() == 2);
  CHECK(file.domain.polylines[1].tag == "cut");
  CHECK(file.domain.polylines[1].points.back() == Vec2{3, 1.5});
  REQUIRE(file.domain.points.size() == 3);
  CHECK(file.domain.points[2].position == Vec2{0.7, 0.5});
  CHECK(file.warnings.empty());
  const auto open = geojson(polygon("[[[0,0],[1,0],[0,1]]]"));
  CHECK(open.warnings.size() == 1);
  CHECK(total_area(open.domain) == 0.5);
}

TEST_CASE("GeoJSON that is wrong is refused with its line") {
  const std::string wrong[] = {"[]",
                               "7",
                               "{}",
                               R"({"type": "Circle"})",
                               R"({"type": "Polygon"})",
                               polygon(ring),
                               polygon("[[" + ring + "]]"),
                               polygon("[[[0,0],[1]]]"),
                               polygon("[[[0,0],[1,\"2\"]]]"),
                               polygon("[[[0,0],[1,null]]]"),
                               polygon("[[[0,0],[1,[2]]]]"),
                               polygon("[[[0,0],[[1,2]]]]"),
                               polygon("[[[[[0,0]]]]]"),
                               polygon("{}"),
                               R"({"type": "FeatureCollection", "features": [[]]})",
                               R"({"type": "Feature", "geometry": [1]})",
                               polygon("[" + ring + "]") + "x",
                               std::string(100'000, '['),
                               "{\"a\": " + std::string(100'000, '[')};
  for (const std::string& text : wrong) {
    INFO(text.substr(0, 200));
    const Error error = refusal(text, DomainFormat::geojson);
    CHECK(error.code == ErrorCode::parse_error);
    CHECK(error.where.line > 0);
  }
  for (const std::string number : {"1e309", "NaN", "-Infinity"})
    CHECK(refusal(polygon("[[[0,0],[1," + number + "]]]"), DomainFormat::geojson).code ==
          ErrorCode::non_finite);
}

TEST_CASE(".poly: markers, holes, region names, points inside") {
  const auto file = lpq_test::read_file(
      poly_square +
          "5 1\n0 0 1 -3\n1 1 2 0\n2 2 3 0\n3 3 0 0\n4 1 3 8\n0\n2\n0 0.5 0.25 6\n1 3 1.9 2.5 1\n",
      DomainFormat::poly);
  REQUIRE(file.domain.regions.size() == 2);  // the diagonal divides
  std::vector<std::string> names{file.domain.regions[0].name, file.domain.regions[1].name};
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"region 2.5", "region 6"});
  const auto& tags = file.domain.regions[file.domain.regions[0].name == "region 6" ? 0 : 1].tags;
  REQUIRE(tags.size() == 1);
  CHECK(std::count(tags[0].begin(), tags[0].end(), "marker -3") == 1);
  CHECK(std::count(tags[0].begin(), tags[0].end(), "marker 8") == 1);
  REQUIRE(file.domain.points.size() == 1);
  CHECK(file.domain.points[0].tag == "marker 5");
  REQUIRE(file.warnings.size() == 2);  // vertex 5 is outside, region 1 has an area limit
  for (const Warning& warning : file.warnings) CHECK(warning.code == ErrorCode::ignored);
  CHECK(make_domain(file.domain).has_value());
  // A hole point takes its own face away, nothing more.
  const auto half = lpq_test::read_file(
      poly_square + "5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 1 3\n1\n0 0.25 0.25\n", DomainFormat::poly);
  CHECK(total_area(half.domain) == 4);
}

TEST_CASE(".poly: points of holes and regions without effect are told, and vertices on segments") {
  const std::string square = "6 2 0 1\n0 0 0 0\n1 4 0 0\n2 4 2 0\n3 0 2 0\n4 1 0 5\n5 2 1 5\n";
  const std::string segments = "5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 0 2\n";
  struct Case {
    std::string end, told;
    Vec2 at;
  };
  const Case cases[] = {
      {"1\n0 9 1\n", "Holes whose point no segments enclose had no effect: 1.", {9, 1}},
      {"1\n0 2 1\n", "on a segment count on one side of it only: 1.", {2, 1}},
      {"0\n2\n0 9 1 7\n1 8 1 7\n", "Regions whose point lies outside, or in a hole", {9, 1}},
      {"1\n0 3 .5\n1\n0 2 .5 7\n", "Regions whose point lies outside, or in a hole", {2, .5}},
      {"0\n2\n0 3 .5 1\n1 2 .5 2\n", "that had a name before gave it theirs instead: 1.", {2, .5}}};
  for (const Case& one : cases) {
    INFO(one.end);
    const auto file = lpq_test::read_file(square + segments + one.end, DomainFormat::poly);
    REQUIRE(file.warnings.size() == 2);
    CHECK(file.warnings[0].message.find("Vertices on a segment") == 0);  // 4 outside, 5 inside
    CHECK(file.warnings[0].message.find(": 2.") != std::string::npos);
    CHECK(file.warnings[1].message.find(one.told) != std::string::npos);
    CHECK(file.warnings[1].where.x == one.at.x);
    CHECK(file.warnings[1].where.y == one.at.y);
    CHECK(file.domain.points.empty());
    CHECK(make_domain(file.domain).has_value());
  }
}

TEST_CASE(".poly that is wrong is refused with its line") {
  const std::pair<std::string, std::int64_t> wrong[] = {
      {"# only a comment\n", 1},
      {"0 2 0 0\n4 0\n", 1},
      {"4 3 0 0\n", 1},
      {"x 2\n", 1},
      {"-1 2\n", 1},
      {"4000000000 2 0 0\n1 0 0\n", 2},
      {"2 2 0 0\n1 0 0\n3 1 1\n", 3},
      {"1 2 0 0\n5 0 0\n", 2},
      {"1 2 0 0\n1 0\n", 2},
      {"1 2 0 0\n1 0 nan\n", 2},
      {"1 2 0 0\n1 0 1e999\n", 2},
      {"1 2 0 0\n1 0 0\n1 0\n1 1 2\n", 4},
      {"1 2 0 0\n1 0 0\n99999999999999999999 0\n", 3},
      {poly_square + "4 0\n1 0 1\n2 1 2\n3 2 3\n4 3 0\n", 12},
      {poly_square + "4 0\n1 0 1\n2 1 2\n3 2 3\n4 3 0\n1\n", 13}};
  for (const auto& [text, line] : wrong) {
    INFO(text);
    const Error error = refusal(text, DomainFormat::poly);
    CHECK(error.code == ErrorCode::parse_error);
    CHECK(error.where.line == line);
  }
  CHECK(refusal(poly_square + "1 0\n0 0 1\n0\n", DomainFormat::poly).code == ErrorCode::empty);
}

TEST_CASE("a written mesh is read as the domain of its regions") {
  const OutputMesh mesh = two_region_mesh();
  double area = 0;
  for (const Face& face : mesh.faces) {
    std::vector<Vec2> corners;
    for (int k = 0; k < corner_count(face); ++k) corners.push_back(mesh.points[face[k]]);
    area += signed_area(corners);
  }
  for (const MshVersion version : {MshVersion::v2_2, MshVersion::v4_1}) {
    const auto file = lpq_test::read_file(write_msh(mesh, version), DomainFormat::msh);
    REQUIRE(file.domain.regions.size() == 2);
    CHECK(file.domain.regions[0].name == "steel 'A36' & <co>");
    CHECK(file.domain.regions[1].name == "air");
    CHECK(std::abs(total_area(file.domain) - area) < 1e-15);
    std::vector<std::string> tags;
    for (const auto& region : file.domain.regions)
      for (const auto& loop : region.tags) tags.insert(tags.end(), loop.begin(), loop.end());
    CHECK(std::count(tags.begin(), tags.end(), "inlet") == 2);
    CHECK(std::count(tags.begin(), tags.end(), "wall") == 2);
    CHECK(make_domain(file.domain).has_value());
  }
}

TEST_CASE("MSH: lines that miss each other by rounding close an outline") {
  const auto triangle = [](const char* last) {
    return std::string(
               "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n") +
           "4 " + last + " 0 0\n$EndNodes\n$Elements\n3\n1 1 2 0 1 1 2\n2 1 2 0 1 2 3\n" +
           "3 1 2 0 1 3 4\n$EndElements\n";
  };
  CHECK(total_area(lpq_test::read_file(triangle("2e-16"), DomainFormat::msh).domain) == 0.5);
  CHECK(refusal(triangle("1e-9"), DomainFormat::msh).code == ErrorCode::parse_error);
}

TEST_CASE("MSH: lines inside, holes in the mesh, turned faces, faces that overlap") {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  std::string nodes = "$Nodes\n16\n";
  for (int i = 0; i < 16; ++i)
    nodes += std::to_string(i) + " " + std::to_string(i % 4) + " " + std::to_string(i / 4) + " 0\n";
  nodes += "$EndNodes\n";
  std::string quads;
  int count = 0;
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;  // a hole in the middle
    const int a = 4 * (i / 3) + i % 3;
    const int corners[] = {a, a + 1, a + 5, a + 4};
    quads += std::to_string(++count) + " 3 2 0 1";
    for (int k = 0; k < 4; ++k)
      quads.append(" ").append(std::to_string(corners[i % 2 == 0 ? k : 3 - k]));
    quads += "\n";
  }
  const auto elements = [&](const std::string& more, int extra) {
    return head + nodes + "$Elements\n" + std::to_string(count + extra) + "\n" + quads + more +
           "$EndElements\n";
  };
  const auto file = lpq_test::read_file(elements("20 1 2 0 3 1 5\n", 1), DomainFormat::msh);
  REQUIRE(file.domain.regions.size() == 1);
  CHECK(file.domain.regions[0].loops.size() == 2);
  CHECK(total_area(file.domain) == 8);
  CHECK(file.domain.polylines.size() == 1);
  const Error error = refusal(elements("20 2 2 0 1 0 1 5\n", 1), DomainFormat::msh);
  CHECK(error.code == ErrorCode::parse_error);
  CHECK(error.where.has_point);
  const Error open =
      refusal(head + nodes + "$Elements\n1\n1 1 2 0 1 0 1\n$EndElements\n", DomainFormat::msh);
  CHECK(open.where.has_point);
  CHECK(open.message.find(": nothing else ends there. ") != std::string::npos);
  CHECK(refusal(head + nodes + "$Elements\n0\n$EndElements\n", DomainFormat::msh).code ==
        ErrorCode::empty);
  for (const char* format : {"2.2 1 8", "4.2 0 8", "4.1 1 8", "4 1 8", "3.0 0 8"})
    CHECK(refusal(std::string("$MeshFormat\n") + format + "\n$EndMeshFormat\n", DomainFormat::msh)
              .where.line == 2);
}

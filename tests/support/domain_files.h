// Small domain files in every format that is read, and measures of what readers make of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "geometry/polygon.h"
#include "io/domain/domain_format.h"

namespace lpq_test {

/// A reader's result; the test fails with the reader's sentence if there is none.
inline lpq::DomainFile read_file(const std::string& text, lpq::DomainFormat format) {
  auto file = lpq::read_domain(text, format);
  INFO((file ? std::string() : file.error().message));
  REQUIRE(file.has_value());
  return *std::move(file);
}

inline lpq::Error refusal(const std::string& text, lpq::DomainFormat format) {
  const auto file = lpq::read_domain(text, format);
  REQUIRE_FALSE(file.has_value());
  CHECK_FALSE(file.error().message.empty());
  return file.error();
}

inline double loop_area(const lpq::Loop& loop) { return std::abs(lpq::signed_area(loop)); }

/// The largest loop less the others.
inline double region_area(const lpq::DomainInput::Region& region) {
  double sum = 0, largest = 0;
  for (const lpq::Loop& loop : region.loops) {
    sum += loop_area(loop);
    largest = std::max(largest, loop_area(loop));
  }
  return 2 * largest - sum;
}

inline double total_area(const lpq::DomainInput& input) {
  double sum = 0;
  for (const auto& region : input.regions) sum += region_area(region);
  return sum;
}

/// Every coordinate and every edge tag of a domain is where a domain may have one.
inline bool is_well_formed(const lpq::DomainInput& input) {
  for (const auto& region : input.regions) {
    if (region.tags.size() > region.loops.size()) return false;
    for (std::size_t l = 0; l < region.loops.size(); ++l) {
      if (l < region.tags.size() && region.tags[l].size() > region.loops[l].size()) return false;
      for (const lpq::Vec2 p : region.loops[l])
        if (!lpq::is_finite(p)) return false;
    }
  }
  for (const auto& line : input.polylines)
    for (const lpq::Vec2 p : line.points)
      if (!lpq::is_finite(p)) return false;
  return true;
}

/// DXF from a line of groups, "10 0" and so on; `before` are whole sections.
inline std::string dxf(const std::string& entities, const std::string& before = {}) {
  std::string groups = before + (before.empty() ? "" : " ") + "0 SECTION 2 ENTITIES " + entities +
                       (entities.empty() ? "" : " ") + "0 ENDSEC 0 EOF";
  std::replace(groups.begin(), groups.end(), ' ', '\n');
  return groups + "\n";
}
/// The BLOCKS section with these blocks.
inline std::string dxf_blocks(const std::string& blocks) {
  return "0 SECTION 2 BLOCKS " + blocks + " 0 ENDSEC";
}

inline std::string svg(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + content +
         "\n</svg>\n";
}

/// A rectangle 4 x 2 with a hole 1 x 1 and something else of each format.
inline std::vector<std::pair<lpq::DomainFormat, std::string>> sample_domain_files() {
  using lpq::DomainFormat;
  return {
      {DomainFormat::json,
       R"({"loops": [[[0,0],[4,0],[4,2],[0,2]], [[1,0.5],[2,0.5],[2,1.5],[1,1.5]]]})"},
      {DomainFormat::geojson,
       R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": {"coordinates":
[[[0,0],[4,0],[4,2],[0,2],[0,0]], [[1,0.5],[2,0.5],[2,1.5],[1,1.5],[1,0.5]]], "type": "Polygon"},
"properties": {"name": "plate", "n": null}}, {"type": "Feature", "properties": {"tag": "crack"},
"geometry": {"type": "LineString", "coordinates": [[3, 0.5], [3, 1.5, 7]]}}]})"},
      {DomainFormat::svg,
       svg("<!-- plate --><g transform='translate(1 1) scale(2)'><rect x='-.5' y='-1.5' width='2' "
           "height='1' id='a &amp; b'/></g>\n<path d='M1-.5h1v-1h-1z' "
           "fill='none'/><path d='M3-.5C3-1 3-1 3.1-1.5' style='fill:none'/><![CDATA[<rect/>]]>")},
      {DomainFormat::poly,
       "# plate\n8 2 1 1\n1 0 0 .5 0\n2 4 0 0 0\n3 4 2 0 0\n4 0 2 0 3\n5 1 .5 0 0\n6 2 .5 0 0\n"
       "7 2 1.5 0 0\n8 1 1.5 0 0\n8 1\n1 1 2 7\n2 2 3 0\n3 3 4 0 # top\n4 4 1 0\n5 5 6 9\n6 6 7 9\n"
       "7 7 8 9\n8 8 5 9\n1\n1 1.5 1\n1\n1 3 1 5 0.1\n"},
      {DomainFormat::msh,
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 7 \"wall\"\n$EndPhysicalNames\n"
       "$Nodes\n8\n1 0 0 0\n2 4 0 0\n3 4 2 0\n4 0 2 0\n5 1 .5 0\n6 2 .5 0\n7 2 1.5 0\n8 1 1.5 0\n"
       "$EndNodes\n$Elements\n8\n1 1 2 7 1 1 2\n2 1 2 7 1 2 3\n3 1 2 7 1 3 4\n4 1 2 7 1 4 1\n"
       "5 1 2 0 2 5 6\n6 1 2 0 2 6 7\n7 1 2 0 2 7 8\n8 1 2 0 2 8 5\n$EndElements\n"},
      {DomainFormat::dxf,
       dxf("0 LWPOLYLINE 8 plate 90 4 70 1 10 0 20 0 10 4 20 0 10 4 20 2 10 0 20 2 "
           "0 LINE 8 0 10 1 20 .5 11 2 21 .5 0 LINE 8 0 10 2 20 .5 11 2 21 1.5 "
           "0 POLYLINE 66 1 70 0 0 VERTEX 10 2 20 1.5 0 VERTEX 10 1 20 1.5 0 VERTEX 10 1 20 0.5 "
           "0 SEQEND 0 TEXT 1 note")},
  };
}

}  // namespace lpq_test

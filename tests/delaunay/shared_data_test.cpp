// Point sets and segment sets that broke other triangulators.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.h"
#include "delaunay/delaunay.h"
#include "mesh/validate.h"
#include "support/delaunay_checks.h"

using namespace lpq_test;
using lpq::ErrorCode;
using lpq::triangulate;

namespace {

struct File {
  std::string name, text;
};

std::vector<File> files_in(const std::string& folder) {
  const std::filesystem::path root = std::filesystem::path(LPQ_SHARED_DATA) / "data" / folder;
  std::vector<File> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(root, missing)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    files.push_back({entry.path().filename().string(),
                     std::string(std::istreambuf_iterator<char>(stream), {})});
  }
  std::sort(files.begin(), files.end(),
            [](const File& a, const File& b) { return a.name < b.name; });
  if (files.empty()) WARN("SKIPPED: nothing tested here because " << root << " has no files");
  return files;
}

using Edge = std::array<Index, 2>;

// Do two segments share a point other than a common end? Exact.
bool conflict(const std::vector<Vec2>& p, const Edge& s, const Edge& t) {
  const auto apart = [&](auto coordinate) {
    const double s0 = coordinate(p[s[0]]), s1 = coordinate(p[s[1]]);
    const double t0 = coordinate(p[t[0]]), t1 = coordinate(p[t[1]]);
    return std::max(s0, s1) < std::min(t0, t1) || std::max(t0, t1) < std::min(s0, s1);
  };
  if (apart([](Vec2 q) { return q.x; }) || apart([](Vec2 q) { return q.y; })) return false;
  const auto on = [&](const Edge& e, Index v) {
    if (p[v] == p[e[0]] || p[v] == p[e[1]]) return false;
    return lpq::orient2d(p[e[0]], p[e[1]], p[v]) == 0 && dot(p[v] - p[e[0]], p[v] - p[e[1]]) < 0;
  };
  if (on(s, t[0]) || on(s, t[1]) || on(t, s[0]) || on(t, s[1])) return true;
  return lpq::orient2d(p[s[0]], p[s[1]], p[t[0]]) * lpq::orient2d(p[s[0]], p[s[1]], p[t[1]]) < 0 &&
         lpq::orient2d(p[t[0]], p[t[1]], p[s[0]]) * lpq::orient2d(p[t[0]], p[t[1]], p[s[1]]) < 0;
}

// Legal: no segment is degenerate, crosses another or runs through a point.
bool is_legal(const std::vector<Vec2>& p, const std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i][0] == edges[i][1]) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (conflict(p, edges[i], edges[j])) return false;
    }
    for (Index v = 0; v < static_cast<Index>(p.size()); ++v) {
      if (conflict(p, edges[i], {v, v})) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("ill-conditioned point sets") {
  for (const File& file : files_in("points")) {
    INFO(file.name);
    const auto raw = points_after(file.text, "points");
    REQUIRE(raw.size() >= 3);
    const auto points = without_duplicates(raw);
    if (points.size() < raw.size()) {
      CHECK(triangulate(raw).error().code == ErrorCode::duplicate_point);
    }
    const auto mesh = triangulate(points);
    REQUIRE(mesh.has_value());
    CHECK(lpq::validate(*mesh).empty());
    CHECK(occupied_circles(*mesh) == 0);
    CHECK(mesh->triangle_count() ==
          2 * mesh->vertex_count() - 2 - static_cast<int>(walls_of(*mesh).size()));
  }
}

TEST_CASE("segment sets in a box: legal ones are meshed, others refused") {
  for (const File& file : files_in("pslg")) {
    INFO(file.name);
    BoundaryMesh boundary;
    boundary.points = points_after(file.text, "vertices");
    const auto numbers = numbers_after(file.text, "edges");
    std::vector<Edge> edges;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      edges.push_back({static_cast<Index>(numbers[i]), static_cast<Index>(numbers[i + 1])});
    }
    const bool legal = is_legal(boundary.points, edges);
    for (const auto& [a, b] : edges) add_segment(boundary, a, b, 0, 0);
    add_loop(boundary, rectangle({-1e5, -1e5}, {1e5, 1e5}), 0, none);
    const auto mesh = triangulate(boundary, {});
    REQUIRE(mesh.has_value() == legal);
    if (!legal) {
      CHECK(mesh.error().where.has_point);
      continue;
    }
    CHECK(lpq::validate(*mesh).empty());
    CHECK(occupied_edges(*mesh) == 0);
    auto expected = expected_walls(boundary);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    CHECK(walls_of(*mesh) == expected);
    CHECK(mesh_area(*mesh) == lpq_test::Approx(4e10));
  }
}

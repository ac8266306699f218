// Meshes of surfaces as they leave: faces with names, features as curves with a face on their left.
#include "shell/output.h"

#include <algorithm>
#include <map>
#include <set>

#include "catch.h"
#include "support/meshed_surface.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// Regions on the left and right of every directed edge, from the faces alone.
std::map<std::array<Index, 2>, std::vector<Index>> sides_of(const OutputMesh& mesh) {
  std::map<std::array<Index, 2>, std::vector<Index>> sides;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < 4; ++k)
      sides[{mesh.faces[f][k], mesh.faces[f][(k + 1) % 4]}].push_back(mesh.region[f]);
  return sides;
}

/// Every edge has the region of a face with that direction on its left, of one against it on its
/// right, and edges of one curve follow one another.
void check_edges(const OutputMesh& mesh) {
  auto sides = sides_of(mesh);
  std::set<std::array<Index, 2>> seen;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const OutputEdge& edge = mesh.edges[e];
    CHECK(seen.insert({std::min(edge.a, edge.b), std::max(edge.a, edge.b)}).second);
    CHECK(sides[{edge.a, edge.b}] == std::vector<Index>{edge.left});
    if (edge.right == none) CHECK(sides[{edge.b, edge.a}].empty());
    if (edge.right != none) CHECK(sides[{edge.b, edge.a}] == std::vector<Index>{edge.right});
    REQUIRE(edge.tag < static_cast<Index>(mesh.tags.size()));
    if (e > 0 && mesh.edges[e - 1].tag == edge.tag) CHECK(mesh.edges[e - 1].b == edge.a);
  }
}

}  // namespace

TEST_CASE("a box leaves as six regions and twelve curves") {
  const ShellOutcome outcome = meshed(box_soup({1, 2, 1}, 3), {.size = 0.25});
  const OutputMesh mesh = shell_output(outcome);
  REQUIRE(mesh.z.size() == mesh.points.size());
  for (std::size_t v = 0; v < mesh.z.size(); ++v)
    CHECK(mesh.point(static_cast<Index>(v)) == outcome.mesh.points[v]);
  CHECK(mesh.regions ==
        std::vector<std::string>{"face 1", "face 2", "face 3", "face 4", "face 5", "face 6"});
  CHECK(mesh.tags.size() == 12);
  CHECK(mesh.tags.front() == "curve 1");
  CHECK(mesh.edges.size() == 8 * 4 + 4 * 8);
  check_edges(mesh);
}

TEST_CASE("faces have the names of their groups") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 2);
  soup.group_names = {"", "lid", "walls"};
  soup.group.assign(soup.triangles.size(), 0);
  const std::size_t side = soup.triangles.size() / 6;
  for (std::size_t t = side; t < 4 * side; ++t) soup.group[t] = t < 2 * side ? 1 : 2;
  const OutputMesh mesh = shell_output(meshed(soup, {.size = 0.25}));
  CHECK(mesh.regions == std::vector<std::string>{"face 1", "lid", "walls face 3", "walls face 4",
                                                 "face 5", "face 6"});
  // Borders of groups that are not kept leave faces of several groups, without a name.
  SurfaceSoup flat = soup_of(plane_square(2));
  flat.group_names = {"left", "right"};
  flat.group.assign(flat.triangles.size(), 0);
  flat.group.back() = 1;
  CHECK(shell_output(meshed(flat, {.size = 0.25, .keep_groups = false})).regions ==
        std::vector<std::string>{"face 1"});
}

TEST_CASE("a border is walked with the surface on its left") {
  const OutputMesh square = shell_output(meshed(soup_of(plane_square(3)), {.size = 0.25}));
  CHECK(square.tags.size() == 4);
  check_edges(square);
  const OutputMesh pipe = shell_output(meshed(soup_of(cylinder(32, 8, 0.5, 1)), {.size = 0.2}));
  CHECK(pipe.tags.size() == 2);  // two rims without a corner
  check_edges(pipe);
  for (const OutputEdge& edge : pipe.edges) CHECK(edge.right == none);
}

TEST_CASE("where sheets meet an edge knows two of them") {
  SurfaceSoup soup = soup_of(plane_square(1));
  const auto first = static_cast<Index>(soup.points.size());
  soup.points.push_back({0, 0, 0});
  soup.points.push_back({1, 0, 0});
  soup.points.push_back({1, 0, 1});
  soup.points.push_back({0, 0, 1});
  soup.points.push_back({1, -1, 0});
  soup.points.push_back({0, -1, 0});
  soup.triangles.push_back({first, first + 1, first + 2});
  soup.triangles.push_back({first, first + 2, first + 3});
  soup.triangles.push_back({first, first + 5, first + 4});
  soup.triangles.push_back({first, first + 4, first + 1});
  const ShellOutcome outcome = meshed(soup, {.size = 0.25});
  const OutputMesh mesh = shell_output(outcome);
  CHECK(mesh.edges.size() == outcome.mesh.edges.size());
  Index meeting = 0;
  for (const OutputEdge& edge : mesh.edges) {
    CHECK(edge.left != none);
    const Vec3 p = midpoint(mesh.point(edge.a), mesh.point(edge.b));
    if (p.y != 0 || p.z != 0) continue;
    ++meeting;
    CHECK(edge.right != none);
  }
  CHECK(meeting == 4);
}

TEST_CASE("a surface run reports times, a hash and its repairs") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 2);
  std::swap(soup.triangles[0][0], soup.triangles[0][1]);
  soup.triangles.push_back(soup.triangles[5]);
  const ShellOutcome outcome = meshed(soup, {.size = 0.5});
  CHECK(outcome.report.hash != 0);
  CHECK(outcome.report.hash == meshed(soup, {.size = 0.5}).report.hash);
  CHECK(outcome.report.hash != meshed(soup, {.size = 0.25}).report.hash);
  std::vector<std::string> stages, warnings;
  for (const StageTime& time : outcome.report.times) stages.push_back(time.stage);
  CHECK(stages == std::vector<std::string>{"repair", "features", "field", "charts", "mesh", "seams",
                                           "shape", "summary"});
  for (const Warning& warning : outcome.report.warnings) warnings.push_back(warning.message);
  CHECK(warnings == std::vector<std::string>{
                        "1 triangle was left out: another one has the same corners.",
                        "1 triangle was turned over, so that neighbours face the same way."});
}

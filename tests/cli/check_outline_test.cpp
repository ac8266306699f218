// check without a domain: faces that lie on each other although each of them is fine.
#include "cli/check_outline.h"

#include "catch.h"
#include "cli/expected_boundary.h"
#include "support/cli_runner.h"
#include "support/contains.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// Squares by their lower left corner and side, with corners in one place as one vertex.
OutputMesh squares(const std::vector<std::array<double, 3>>& list) {
  OutputMesh mesh;
  const auto vertex = [&](Vec2 p) {
    const auto at = std::find(mesh.points.begin(), mesh.points.end(), p);
    if (at == mesh.points.end()) mesh.points.push_back(p);
    return static_cast<Index>(std::find(mesh.points.begin(), mesh.points.end(), p) -
                              mesh.points.begin());
  };
  for (const auto& [x, y, side] : list) {
    const Index a = vertex({x, y}), b = vertex({x + side, y}), c = vertex({x + side, y + side}),
                d = vertex({x, y + side});
    mesh.faces.push_back({a, b, c, d});
    mesh.region.push_back(0);
  }
  return mesh;
}

std::vector<Violation> judge(const std::vector<std::array<double, 3>>& list) {
  const OutputMesh mesh = squares(list);
  const auto outline = own_outline(mesh);
  QuadMesh plain;
  plain.points = mesh.points;
  plain.faces = mesh.faces;
  plain.region = mesh.region;
  CHECK(validate(plain, {outline}).empty());
  return check_own_outline(mesh.points, outline);
}

void check_found(const std::vector<std::array<double, 3>>& list, const char* what, Vec2 at) {
  const auto found = judge(list);
  INFO(what);
  REQUIRE_FALSE(found.empty());
  CHECK(contains(found[0].what, what));
  CHECK(found[0].point == at);
}

}  // namespace

TEST_CASE("faces beside each other, in rings and in corners are fine") {
  CHECK(judge({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}).empty());
  // Eight squares around nothing, and one in that hole that touches none, or two corners.
  std::vector<std::array<double, 3>> ring;
  for (int i = 0; i < 9; ++i)
    if (i != 4) ring.push_back({4.0 * (i % 3), 4.0 * (i / 3), 4});
  CHECK(judge(ring).empty());
  ring.push_back({5, 5, 1});
  CHECK(judge(ring).empty());
  CHECK(judge({{0, 0, 1}, {1, 1, 1}, {2, 0, 1}, {0, 2, 1}}).empty());
  CHECK(judge({{0, 0, 1}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}}).empty());
}

TEST_CASE("faces that lie on each other are found with their place") {
  check_found({{0, 0, 2}, {1, 1, 2}}, "cross", {2, 1});
  check_found({{0, 0, 2}, {2, 0, 1}}, "does not end there", {2, 1});
  check_found({{0, 0, 2}, {2, 0.5, 1}}, "does not end there", {2, 0.5});
  check_found({{0, 0, 3}, {1, 1, 1}}, "lie on other faces", {1, 1});
  check_found({{0, 0, 9}, {1, 1, 6}, {2, 2, 1}}, "lie on other faces", {1, 1});
  check_found({{0, 0, 1}, {-3, -3, 9}, {5.5, 0, 0.25}}, "lie on other faces", {0, 0});
}

TEST_CASE("faces that share a corner may overlap there") {
  // Two rhombs with their corners at the origin, one within the angle of the other.
  OutputMesh mesh;
  mesh.points = {{0, 0}, {4, -4}, {9, 0}, {4, 4}, {2, -1}, {3, 0}, {2, 1}};
  mesh.faces = {{0, 1, 2, 3}, {0, 4, 5, 6}};
  const auto found = check_own_outline(mesh.points, own_outline(mesh));
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].what, "overlap at vertex 0"));
  mesh.points[4] = {-2, 1};  // the other way
  mesh.points[5] = {-3, 0};
  mesh.points[6] = {-2, -1};
  CHECK(check_own_outline(mesh.points, own_outline(mesh)).empty());
}

TEST_CASE("check says so, and what clockwise faces have in common") {
  const ScratchFolder folder("check_outline");
  const auto check = [&](const std::string& text) {
    return run({"check", folder.write("m.obj", text)});
  };
  const auto hanging = check(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 1 .5 0\nf 1 2 3 4\nf 2 5 6 7\n");
  CHECK(hanging.code == 1);
  CHECK(contains(hanging.err, "(at 1 0.5)"));
  CHECK_FALSE(contains(hanging.out, "valid  "));
  const auto clockwise = check("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 4 3 2 1\n");
  CHECK(clockwise.code == 1);
  CHECK(contains(clockwise.err, "Every face runs clockwise"));
}

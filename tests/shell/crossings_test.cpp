// Faces that go through each other: against a look at every pair of triangles, those that touch
// only, and what a run does about them.
#include "shell/crossings.h"

#include <cmath>
#include <string>

#include "base/rng.h"
#include "catch.h"
#include "shell/mesh_surface.h"
#include "shell/topology.h"
#include "support/meshed_surface.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

struct Faces {
  std::vector<Vec3> points;
  std::vector<Face> faces;

  /// n x n quads from a corner along u and v.
  void add_sheet(Vec3 corner, Vec3 u, Vec3 v, Index n) {
    const auto first = static_cast<Index>(points.size());
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i)
        points.push_back(corner + (double(i) / n) * u + (double(j) / n) * v);
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) {
        const Index a = first + j * (n + 1) + i;
        faces.push_back({a, a + 1, a + n + 2, a + n + 1});
      }
  }
  std::vector<FaceCrossing> crossings(std::size_t limit = 1000) const {
    return find_crossings(points, faces, {}, limit);
  }
};

double volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(b - a, cross(c - a, d - a)); }

bool pierces(Vec3 p, Vec3 q, const std::array<Vec3, 3>& t) {
  const auto& [a, b, c] = t;
  if ((volume(a, b, c, p) > 0) == (volume(a, b, c, q) > 0)) return false;
  const bool left = volume(p, q, a, b) > 0;
  return (volume(p, q, b, c) > 0) == left && (volume(p, q, c, a) > 0) == left;
}

bool cross_somehow(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  for (int k = 0; k < 3; ++k)
    if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
  return false;
}

SurfaceSoup moved(SurfaceSoup soup, Vec3 by) {
  for (Vec3& p : soup.points) p = p + by;
  return soup;
}

/// A solid of n sides round the z axis, its corners turned by `turned`.
SurfaceSoup prism(Index n, double radius, double height, double turned) {
  SurfaceSoup soup;
  for (Index i = 0; i < n; ++i)
    for (const double z : {0.0, height}) {
      const double angle = turned + turn * i / n;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  for (Index i = 0; i < n; ++i) {
    const Index a = 2 * i, b = 2 * ((i + 1) % n);
    soup.triangles.push_back({a, b, b + 1});
    soup.triangles.push_back({a, b + 1, a + 1});
    if (i == 0 || i == n - 1) continue;
    soup.triangles.push_back({0, b, a});
    soup.triangles.push_back({1, a + 1, b + 1});
  }
  return soup;
}

bool tells(const ShellOutcome& outcome, const std::string& words) {
  for (const Warning& warning : outcome.report.warnings)
    if (warning.message.find(words) != std::string::npos) return true;
  return false;
}

/// Two half spheres of radius 1 and 1 - wall, closed by a rim.
SurfaceSoup thin_dome(double wall) {
  SurfaceSoup soup = soup_of(sphere_cap(16, 0.25 * turn));
  const auto outside = static_cast<Index>(soup.points.size());
  const std::vector<Tri> cap = soup.triangles;
  for (Index v = 0; v < outside; ++v) soup.points.push_back((1 - wall) * soup.points[v]);
  for (const auto& [a, b, c] : cap)
    soup.triangles.push_back({a + outside, c + outside, b + outside});
  for (Index i = 0; i < 96; ++i) {
    const Index a = outside - 96 + i, b = outside - 96 + (i + 1) % 96;
    soup.triangles.push_back({b, a, a + outside});
    soup.triangles.push_back({b, a + outside, b + outside});
  }
  return soup;
}

std::string told(const ShellOutcome& outcome) {
  for (const Warning& warning : outcome.report.warnings)
    if (warning.message.starts_with("Pairs of quads that go through each other"))
      return warning.message;
  return {};
}

}  // namespace

TEST_CASE("sheets through each other are counted, pair by pair") {
  Faces sheets;
  sheets.add_sheet({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4);
  sheets.add_sheet({0.5, 1.5, -2.3}, {3, 0, 0}, {0, 0, 4}, 1);  // stands in one row of it
  const std::vector<FaceCrossing> found = sheets.crossings();
  REQUIRE(found.size() == 4);
  for (Index k = 0; k < 4; ++k) {
    CHECK(found[k].faces == std::array<Index, 2>{4 + k, 16});
    CHECK(std::abs(found[k].at.y - 1.5) + std::abs(found[k].at.z) < 1e-12);
  }
  CHECK(sheets.crossings(3).size() == 3);
  std::vector<Index> body(25, 0);  // another body may stand there
  body.resize(sheets.points.size(), 1);
  CHECK(find_crossings(sheets.points, sheets.faces, body, 10).empty());
}

TEST_CASE("the tree finds the triangles that a look at every pair finds") {
  Rng rng(5);
  const auto random_point = [&] {
    const double x = rng.between(-1, 1), y = rng.between(-1, 1), z = rng.between(-1, 1);
    return Vec3{x, y, z};
  };
  Faces heap;
  for (Index k = 0; k < 120; ++k) {
    const Vec3 at = 1.5 * random_point();
    for (int i = 0; i < 3; ++i) heap.points.push_back(at + random_point());
    heap.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2, none});
  }
  std::size_t all = 0;
  for (Index f = 0; f < 120; ++f)
    for (Index g = 0; g < f; ++g) {
      const Vec3 *p = &heap.points[3 * f], *q = &heap.points[3 * g];
      all += cross_somehow({p[0], p[1], p[2]}, {q[0], q[1], q[2]});
    }
  const std::size_t found = heap.crossings(100'000).size();
  CHECK(all > 100);
  CHECK(found <= all);
  CHECK(found >= all - all / 50);  // some go through by next to nothing
}

TEST_CASE("faces that touch, lie on each other or fold do not go through each other") {
  Faces boxes;  // the upper one stands on the other's top, with faces of another size
  boxes.add_sheet({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, 3);
  boxes.add_sheet({0, 0, -1}, {3, 0, 0}, {0, 0, 1}, 3);
  boxes.add_sheet({0.3, 0.4, 0}, {2, 0, 0}, {0, 2, 0}, 3);
  boxes.add_sheet({0.3, 0.4, 0}, {2, 0, 0}, {0, 0, 1}, 3);
  boxes.add_sheet({0.3, 0, 0}, {2, 0, 0}, {0, 0, 1}, 5);  // flush with a side below
  CHECK(boxes.crossings().empty());
  // As a file would round it.
  for (std::size_t v = 0; v < boxes.points.size(); ++v) boxes.points[v].z += v % 2 ? 1e-6 : -1e-6;
  CHECK(boxes.crossings().empty());

  Faces seam;  // both have points of their own there, which coincide
  seam.add_sheet({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 4);
  seam.add_sheet({0, 0, 0}, {2, 0, 0}, {0, 0.1, 1}, 4);
  seam.add_sheet({0, 0, 0}, {2, 0, 0}, {0, -0.1, 1}, 4);
  CHECK(seam.crossings().empty());

  Faces folded;  // neighbours that share an edge, nearly on each other
  folded.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.9, 0.001}, {0, 0.9, -0.001}};
  folded.faces = {{0, 1, 2, 3}, {1, 0, 5, 4}};
  CHECK(folded.crossings().empty());

  Faces twice;
  twice.add_sheet({0, 0, 0}, {2, 0, 0}, {0, 2, 0.5}, 4);
  twice.add_sheet({0, 0, 0}, {2, 0, 0}, {0, 2, 0.5}, 4);
  twice.add_sheet({0, 0, 0}, {2, 0, 0}, {0, 2, 0.5}, 3);
  CHECK(twice.crossings().empty());
}

TEST_CASE("bent quads go through each other only if they do with both diagonals") {
  Faces bent;  // a saddle, and a flat quad between its diagonals
  bent.points = {{0, 0, 0},       {1, 0, 0.4},     {1, 1, 0},       {0, 1, 0.4},
                 {0.4, 0.4, 0.1}, {0.6, 0.4, 0.1}, {0.6, 0.6, 0.3}, {0.4, 0.6, 0.3}};
  bent.faces = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  CHECK(bent.crossings().empty());
  bent.points[4].z = bent.points[5].z = -0.2;  // through both now
  bent.points[6].z = bent.points[7].z = 0.6;
  CHECK(bent.crossings().size() == 1);
}

TEST_CASE("where the walls of a surface are thinner than its quads cut off, quads get smaller") {
  const ShellOutcome thin = meshed(thin_dome(0.005), {.size = 0.2});
  CHECK(thin.report.rounds > 1);
  CHECK(shell_topology(thin.mesh.faces).border_edges == 0);
  CHECK(mesh_crossings(thin.surface, thin.mesh).empty());
  CHECK(told(thin).empty());
  const ShellOutcome thick = meshed(thin_dome(0.1), {.size = 0.2});
  CHECK(thick.report.rounds == 1);
}

TEST_CASE("crossings that are left are told") {
  const ShellOutcome outcome = meshed(thin_dome(2e-4), {.size = 0.3});
  const std::vector<FaceCrossing> crossings = mesh_crossings(outcome.surface, outcome.mesh);
  REQUIRE_FALSE(crossings.empty());
  for (const FaceCrossing& crossing : crossings) CHECK_FALSE(crossing.given);
  CHECK(told(outcome).find(": " + std::to_string(crossings.size()) + ", the first near (") !=
        std::string::npos);
  CHECK(told(outcome).find("smaller size") != std::string::npos);
}

TEST_CASE("a surface that goes through itself is not what smaller quads mend") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 3);
  SurfaceSoup other = box_soup({1, 1, 1}, 4);
  const auto shift = static_cast<Index>(soup.points.size());
  for (const Vec3 p : other.points) soup.points.push_back(p + Vec3{0.43, 0.37, 0.41});
  for (const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({a + shift, b + shift, c + shift});
  const ShellOutcome outcome = meshed(soup, {.size = 0.2});
  CHECK(outcome.report.rounds == 1);
  const std::vector<FaceCrossing> crossings = mesh_crossings(outcome.surface, outcome.mesh);
  REQUIRE_FALSE(crossings.empty());
  for (const FaceCrossing& crossing : crossings) CHECK(crossing.given);
  CHECK(told(outcome).find("The surface goes through itself there") != std::string::npos);
}

TEST_CASE("however often a surface goes through itself, what quads do there is given") {
  constexpr Index slats = 85;  // in two directions, each through all of the other
  Faces mesh;
  for (Index i = 0; i < slats; ++i) {
    const double at = i + 0.5;
    mesh.add_sheet({at, 0, 0}, {0, slats, 0}, {0, 0, 1}, 1);
    mesh.add_sheet({0, at, 0.1}, {slats, 0, 0}, {0, 0, 1}, 1);
  }
  SurfaceMesh surface;
  surface.points = mesh.points;
  for (const Face& f : mesh.faces) {
    surface.triangles.push_back({f[0], f[1], f[2]});
    surface.triangles.push_back({f[0], f[2], f[3]});
  }
  ShellMesh shell;
  shell.points = mesh.points;
  shell.faces = mesh.faces;
  shell.places.resize(shell.points.size());
  REQUIRE(find_crossings(surface.points, faces_of(surface.triangles), {}, 10'000).size() == 10'000);
  const std::vector<FaceCrossing> crossings = mesh_crossings(surface, shell);
  CHECK(crossings.size() == slats * slats);
  for (const FaceCrossing& crossing : crossings) REQUIRE(crossing.given);
  // Elsewhere it is not.
  for (Vec3& p : surface.points) p.z += 10;
  for (const FaceCrossing& crossing : mesh_crossings(surface, shell)) REQUIRE(!crossing.given);
}

TEST_CASE("bodies that go into each other are told, those that fit are not") {
  const SurfaceSoup box = box_soup({1, 1, 1}, 3), other = box_soup({1, 1, 1}, 4);
  const std::string words = "go through each other: ";
  const ShellOutcome deep =
      meshed(as_bodies({box, moved(other, {0.43, 0.37, 0.41})}), {.size = 0.2});
  CHECK(tells(deep, "Bodies 0 (body 1) and 1 (body 2) " + words));
  CHECK(told(deep).empty());  // each mesh by itself is sound
  const SurfaceSoup fine = box_soup({1, 1, 1}, 40);
  CHECK(tells(meshed(as_bodies({fine, moved(fine, {0.43, 0.37, 0.41})}), {.size = 0.2}), words));
  // Side by side, a little into each other, and a rod in another, of which it is as wide.
  CHECK_FALSE(tells(meshed(as_bodies({box, moved(other, {1, 0.2, 0})}), {.size = 0.2}), words));
  CHECK_FALSE(tells(meshed(as_bodies({box, moved(other, {0.99, 0.2, 0})}), {.size = 0.2}), words));
  const SurfaceSoup rod = prism(24, 1, 3, 0), round = prism(24, 1, 3, turn / 60);
  CHECK_FALSE(tells(meshed(as_bodies({rod, round}), {.size = 0.3}), words));
}

TEST_CASE("a surface that goes through itself is told though no quads do") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 3);
  const SurfaceSoup pin = moved(prism(8, 0.03, 0.5, 0), {0.5, 0.5, 0.9});
  const auto shift = static_cast<Index>(soup.points.size());
  soup.points.insert(soup.points.end(), pin.points.begin(), pin.points.end());
  for (const auto& [a, b, c] : pin.triangles)
    soup.triangles.push_back({a + shift, b + shift, c + shift});
  const ShellOutcome outcome = meshed(soup, {.size = 0.25});
  CHECK((tells(outcome, "The surface goes through itself: ") || !told(outcome).empty()));
  CHECK_FALSE(tells(meshed(box_soup({1, 1, 1}, 3), {.size = 0.25}), "goes through itself"));
}

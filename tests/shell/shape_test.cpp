// Shape optimisation on surfaces: a mesh that was thrown into disorder finds back without leaving
// the surface or its features, and what no position of the vertices mends gets other quads.
#include "shell/shape/shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"
#include "shell/mesh_surface.h"
#include "shell/place.h"
#include "shell/quality.h"
#include "shell/shape/cover.h"
#include "shell/shape/freedom.h"
#include "shell/shape/mend.h"
#include "shell/shape/outside.h"
#include "shell/shape/refills.h"
#include "shell/shape/short_sides.h"
#include "shell/shape/smoother.h"
#include "shell/topology.h"
#include "support/optimise_shape.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"
#include "surface/curves.h"
#include "surface/repair.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// A mesh of a surface that needs no cuts, with what it was made from.
struct Meshed {
  ShellOutcome outcome;
  std::vector<double> size;
  SurfaceFeatures features;
  SurfaceCurves curves;
  CurveMesh nodes;
  SurfaceCrossField cross;
  Atlas atlas;

  Meshed(const SurfaceSoup& soup, double h) : outcome(*mesh_surface(soup, {.size = h})) {
    size.assign(outcome.surface.points.size(), h);
    features = find_features(outcome.surface, size);
    curves = trace_curves(outcome.surface, features);
    nodes = *mesh_curves(outcome.surface, features, curves, size);
  }
  Charted charted() const {
    return {outcome.surface, features, cross, size, atlas, features, curves, nodes};
  }
  ShellMesh& mesh() { return outcome.mesh; }
};

/// Throws every vertex about by up to `most`, on the surface or along its feature.
void shake(Meshed& meshed, double most, std::uint64_t seed) {
  const Charted charted = meshed.charted();
  const ShapeGround ground(charted);
  Freedom freedom(ground, vertex_roles(charted, ground.tracks, meshed.mesh()), meshed.mesh());
  Rng rng(seed);
  for (Index v = 0; v < static_cast<Index>(meshed.mesh().points.size()); ++v) {
    freedom.anchor(std::vector<Index>{v});
    const double by[2] = {rng.between(-most, most), rng.between(-most, most)};
    freedom.place(v, by);
  }
}

double feature_length(const ShellMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b] : mesh.edges) sum += distance(mesh.points[a], mesh.points[b]);
  return sum;
}

bool is_on_surface(const Meshed& meshed) {
  const ShellMesh& mesh = meshed.outcome.mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    double sum = 0;
    for (const double weight : mesh.places[v].weight) {
      if (!(weight >= 0)) return false;
      sum += weight;
    }
    if (std::abs(sum - 1) > 1e-12) return false;
    if (distance(point_at(meshed.outcome.surface, mesh.places[v]), mesh.points[v]) > 1e-12)
      return false;
  }
  return true;
}

constexpr double groove_angle = 12 * turn / 360;  // on each side of the x axis

/// A disc with a groove between two creases that leave its middle at 24 degrees; beside the groove
/// it is up to `roughness` high.
SurfaceSoup grooved_disc(double roughness) {
  constexpr int in = 6, out = 28, rounds = 10;
  constexpr double depth[in] = {0, 0.121, 0.161, 0.167, 0.161, 0.121};
  SurfaceSoup soup;
  soup.group_names = {""};
  soup.points.push_back({0, 0, 0});
  Rng rng(1);
  for (int i = 1; i <= rounds; ++i)
    for (int k = 0; k < in + out; ++k) {
      const double share = k < in ? 2.0 * k / in : 0;
      const double angle = k < in ? groove_angle * (share - 1)
                                  : groove_angle + (turn - 2 * groove_angle) * (k - in) / out;
      const double r = 0.1 * i, bump = k > in ? rng.between(0, roughness) : 0;
      soup.points.push_back(
          {r * std::cos(angle), r * std::sin(angle), bump - (k < in ? depth[k] * r : 0)});
    }
  const auto at = [](int i, int k) {
    return static_cast<Index>(i == 0 ? 0 : 1 + (i - 1) * (in + out) + k % (in + out));
  };
  for (int i = 0; i < rounds; ++i)
    for (int k = 0; k < in + out; ++k) {
      soup.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      if (i > 0) soup.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  return soup;
}

/// A square of 16 quads, of which two share a hexagon so that the lower one has a straight corner
/// on the border, and all nodes on the border stay.
struct StraightCorner {
  Meshed meshed{soup_of(plane_square(4)), 0.25};
  std::vector<VertexRole> roles;
  ShellMesh& mesh = meshed.mesh();

  StraightCorner() {
    REQUIRE(mesh.faces.size() == 16);
    const Index a = vertex_at(0.25, 0), b = vertex_at(0.5, 0), c = vertex_at(0.75, 0);
    const Index d = vertex_at(0.75, 0.25), e = vertex_at(0.5, 0.25), f = vertex_at(0.25, 0.25);
    Face *left = face_of({a, b, e, f}), *right = face_of({b, c, d, e});
    REQUIRE((left && right));
    *left = {a, b, c, f};
    *right = {c, d, e, f};
    CHECK(shell_quality(mesh).nonconvex >= 1);
    const Charted charted = meshed.charted();
    roles = vertex_roles(charted, ShapeGround(charted).tracks, mesh);
    for (std::size_t v = 0; v < roles.size(); ++v)
      if (!mesh.is_free(static_cast<Index>(v))) roles[v] = {.kind = VertexRole::Kind::fixed};
  }

  Index vertex_at(double x, double y) const {
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (distance(mesh.points[v], {x, y, 0}) < 1e-6) return static_cast<Index>(v);
    return none;
  }

  Face* face_of(std::array<Index, 4> corners) const {
    std::sort(corners.begin(), corners.end());
    for (Face& face : mesh.faces) {
      Face sorted = face;
      std::sort(sorted.begin(), sorted.end());
      if (sorted == corners) return &face;
    }
    return nullptr;
  }
};

}  // namespace

TEST_CASE("no more iterations are made than are given, but the given ones are") {
  for (const int iterations : {0, 1, 2, 4, 7}) {
    Meshed meshed(box_soup({1, 2, 1}, 3), 0.125);
    shake(meshed, 0.07, 5);
    SmoothOptions options;
    options.iterations = iterations;
    const int made = optimise_shape(meshed.charted(), options, meshed.mesh()).iterations;
    CHECK(made <= iterations);
    CHECK((made > 0) == (iterations > 0));
  }
}

TEST_CASE("a shaken box finds back, and its edges stay where they are") {
  Meshed meshed(box_soup({1, 2, 1}, 3), 0.125);
  const std::vector<Face> faces = meshed.mesh().faces;
  shake(meshed, 0.07, 5);
  CHECK(shell_quality(meshed.mesh()).nonconvex > 0);
  const ShapeStats stats = optimise_shape(meshed.charted(), {}, meshed.mesh());
  CHECK(stats.tangled_before > 0);
  CHECK(stats.tangled_after == 0);
  CHECK(shell_quality(meshed.mesh()).nonconvex == 0);
  CHECK(shell_quality(meshed.mesh()).eta_min > 0.6);
  CHECK(is_on_surface(meshed));
  for (std::size_t v = 0; v < meshed.mesh().points.size(); ++v) {
    const Vec3 p = meshed.mesh().points[v];
    const auto on = [](double x, double end) { return std::abs(x * (end - x)) < 1e-12; };
    const int at_end = on(p.x, 1) + on(p.y, 2) + on(p.z, 1);
    CHECK(at_end >= 1 + static_cast<int>(meshed.mesh().pins[v]));
  }
  // Out of order, the edges along a line would overlap.
  CHECK(feature_length(meshed.mesh()) == Approx(16).epsilon(1e-12));
}

TEST_CASE("a shaken ball and ring are untangled on the surface", "[slow]") {
  for (const SurfaceMesh& surface : {sphere(12), torus(48, 24, 1, 0.4)}) {
    const double h = std::sqrt(surface_area(surface) / 1200);
    Meshed meshed(soup_of(surface), h);
    shake(meshed, 0.5 * h, 6);
    const QuadQuality before = shell_quality(meshed.mesh());
    CHECK(before.nonconvex > 0);
    optimise_shape(meshed.charted(), {}, meshed.mesh());
    const QuadQuality after = shell_quality(meshed.mesh());
    CHECK(after.nonconvex == 0);
    CHECK(after.eta_min > 0.3);
    CHECK(after.eta_mean > 0.9);
    CHECK(is_on_surface(meshed));
  }
}

TEST_CASE("the worst quad does not become worse, nor does a second run") {
  Meshed meshed(soup_of(torus(48, 24, 1, 0.4)), 0.12);
  shake(meshed, 0.02, 7);
  const QuadQuality before = shell_quality(meshed.mesh());
  REQUIRE(before.nonconvex == 0);
  optimise_shape(meshed.charted(), {}, meshed.mesh());
  const QuadQuality once = shell_quality(meshed.mesh());
  CHECK(once.eta_min >= std::min(before.eta_min, 0.5));
  CHECK(once.eta_mean > before.eta_mean);
  optimise_shape(meshed.charted(), {}, meshed.mesh());
  const QuadQuality twice = shell_quality(meshed.mesh());
  CHECK(twice.eta_min >= std::min(once.eta_min, 0.5));
  CHECK(twice.eta_mean > once.eta_mean - 1e-3);
}

TEST_CASE("a straight corner that cannot move gets other quads") {
  StraightCorner square;
  const ShapeStats stats = optimise_shape(square.meshed.charted(), {}, square.mesh);
  CHECK(stats.tangled_before >= 1);
  CHECK(stats.refilled > 0);
  CHECK(stats.tangled_after == 0);
  CHECK(shell_quality(square.mesh).eta_min > 0.4);
}

TEST_CASE("a side without length nearby does not keep a corner straight") {
  // Two nodes of the border almost in one place, as where the sheets of a defective surface meet.
  StraightCorner square;
  const Index corner = square.vertex_at(1, 0), node = square.vertex_at(1, 0.25);
  const double gap = GENERATE(0., 1e-7);
  square.mesh.places[node] = square.mesh.places[corner];
  square.mesh.points[node] = square.mesh.points[corner] + Vec3{0, gap, 0};
  const Charted charted = square.meshed.charted();
  const ShapeGround ground(charted);
  Mender mender(ground, {}, square.mesh, square.roles);
  while (mender.mend_next(0.1, true)) {
  }
  CHECK(mender.stats().refilled > 0);
  for (Index f = 0; f < static_cast<Index>(square.mesh.faces.size()); ++f)
    CHECK((signed_eta(ground, square.mesh, f) > 0.1 || has_short_side(square.mesh, f, 1e-3)));
}

TEST_CASE("a straight corner of a strip one quad wide shares its place with another quad") {
  // Five edges above, three below: nothing but the connectivity can mend the quad in the middle.
  SurfaceSoup soup;
  soup.points = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  Meshed meshed(soup, 0.9);
  ShellMesh& mesh = meshed.mesh();
  mesh = {};
  for (const double x : {0., 1., 2., 3.}) mesh.points.push_back({x, 0, 0});
  for (const double x : {0., 1., 1.35, 1.7, 2.2, 3.}) mesh.points.push_back({x, 1, 0});
  for (const Vec3& p : mesh.points)  // above the diagonal lies the second triangle
    mesh.places.push_back(p.x > 3 * p.y ? SurfacePlace{0, {1 - p.x / 3, p.x / 3 - p.y, p.y}}
                                        : SurfacePlace{1, {1 - p.y, p.x / 3, p.y - p.x / 3}});
  mesh.faces = {{0, 1, 5, 4}, {1, 7, 6, 5}, {1, 2, 8, 7}, {2, 3, 9, 8}};
  const bool mirrored = GENERATE(false, true);
  if (mirrored)  // the neighbour that is divided too lies on the other side
    mesh.faces = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 8, 7, 6}, {2, 3, 9, 8}};
  mesh.face.assign(mesh.faces.size(), 0);
  mesh.pins.assign(mesh.points.size(), Pin::line);
  for (const Index v : {0, 3, 4, 9}) mesh.pins[v] = Pin::corner;
  mesh.edges = {{0, 1}, {0, 4}, {1, 2}, {2, 3}, {3, 9}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}};
  mesh.sides.assign(mesh.edges.size(), {0, none});
  const Charted charted = meshed.charted();
  const ShapeGround ground(charted);
  const std::vector<VertexRole> fixed(mesh.points.size(), {.kind = VertexRole::Kind::fixed});
  const ShapePatch patch = take_patch(mesh, fixed, FaceStars(mesh), {0, 1, 2, 3});
  CHECK(signed_eta(ground, mesh, mirrored ? 2 : 1) < 0.1);
  double best = -1;
  for (ShapePatch& refill : refills(ground, patch, mirrored ? 2 : 1)) {
    const double worst = smooth_patch(ground, {}, refill).worst;
    if (worst <= best) continue;
    best = worst;
    CHECK(shell_topology(refill.mesh.faces).euler == 1);
    CHECK(std::equal(mesh.points.begin(), mesh.points.end(), refill.mesh.points.begin()));
  }
  CHECK(best > 0.4);
}

TEST_CASE("a quad that is nearest to the other side of a sheet is turned") {
  // A pyramid, and under it a square that looks down; the quad between their corners looks up.
  SurfaceSoup soup;
  soup.group_names = {""};
  for (const double z : {0.0, -0.1})
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      soup.points.push_back({1.0 * x, 1.0 * y, z});
  soup.points.push_back({0, 0, 1});
  for (Index k = 0; k < 4; ++k) soup.triangles.push_back({k, (k + 1) % 4, 8});
  const auto turned = [](const SurfaceSoup& sheets) {
    const SurfaceMesh surface = repair_surface(sheets)->mesh;
    const std::vector<double> size(surface.points.size(), 1);
    const SurfaceFeatures features = find_features(surface, size, {.angle = 180});
    const Outside outside(surface, features, size);
    ShellMesh mesh;
    for (Index k = 0; k < 4; ++k) {
      mesh.places.push_back({k, {1, 0, 0}});
      mesh.points.push_back(point_at(surface, mesh.places.back()));
    }
    mesh.faces.push_back({0, 1, 2, 3});
    mesh.face.push_back(0);
    CHECK(outside.at(mesh, 0).z == Approx(1));
    CHECK(outside.flatness(mesh, 0) == Approx(std::sqrt(0.5)));
    return outside.is_turned(mesh, 0);
  };
  CHECK(!turned(soup));
  soup.triangles.push_back({4, 6, 5});
  soup.triangles.push_back({4, 7, 6});
  CHECK(turned(soup));
}

TEST_CASE("gaps are told in sides of the nearest quad, at a vertex in those of the smallest") {
  ShellMesh mesh;  // a square of side 2 and one of side 1, which share a corner
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {3, 2, 0}, {3, 3, 0}, {2, 3, 0}};
  mesh.faces = {{0, 1, 2, 3}, {2, 4, 5, 6}};
  const Cover cover(mesh);
  CHECK(cover.at({0.5, 1, 1}).face == 0);
  CHECK(cover.at({0.5, 1, 1}).distance == Approx(0.5));
  CHECK(cover.at({2.5, 2.5, 1}).distance == Approx(1));
  for (const Index hint : {0, 1}) {
    CHECK(cover.at({2, 2, 1}, hint).face == 1);
    CHECK(cover.at({2, 2, 1}, hint).distance == Approx(1));
  }
}

TEST_CASE("needles have no more places to cover than fit along them") {
  constexpr double h = 0.3;
  constexpr int sides = 240;
  SurfaceSoup soup;  // a disc of needles
  soup.points = {{0, 0, 0}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    soup.points.push_back({3 * std::cos(angle), 3 * std::sin(angle), 0});
    soup.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
  }
  const Meshed meshed(soup, h);
  const std::vector<PlaceToCover> places = places_to_cover(meshed.charted());
  const int along = static_cast<int>(3 / (0.3 * h)) + 1;
  CHECK(static_cast<int>(places.size()) > 2 * sides);
  CHECK(static_cast<int>(places.size()) <= 1 + sides * (along + 1));  // centre, middles, chords
  // Along each needle no piece is left out, down to its narrow end.
  for (const Tri& t : meshed.charted().mesh.triangles) {
    std::vector<double> from_centre{0, 3};
    for (const PlaceToCover& at : places)
      if (meshed.charted().mesh.triangles[at.place.triangle] == t)
        from_centre.push_back(length(at.point));
    std::sort(from_centre.begin(), from_centre.end());
    for (std::size_t i = 1; i < from_centre.size(); ++i)
      CHECK(from_centre[i] - from_centre[i - 1] < 0.45 * h);
  }
}

TEST_CASE("tips that the mesh cuts off are reached") {
  // A ball with a spine that is narrower than a quad.
  SurfaceMesh surface = sphere(12);
  Index tip = 0;
  for (Index v = 0; v < surface.vertex_count(); ++v)
    if (surface.points[v].z > surface.points[tip].z) tip = v;
  surface.points[tip] = 1.12 * surface.points[tip];
  Meshed meshed(soup_of(surface), 0.25);
  shake(meshed, 0.02, 8);
  optimise_shape(meshed.charted(), {}, meshed.mesh());
  const auto& points = meshed.mesh().points;
  const double nearest = std::accumulate(
      points.begin(), points.end(), 1.0,
      [&](double least, Vec3 p) { return std::min(least, distance(p, surface.points[tip])); });
  CHECK(nearest < 0.3 * 0.25);
  const Cover cover(meshed.mesh());
  for (const PlaceToCover& at : places_to_cover(meshed.charted()))
    CHECK(cover.at(at.point).distance < 0.35);
  CHECK(shell_quality(meshed.mesh()).nonconvex == 0);
  CHECK(shell_quality(meshed.mesh()).eta_min > 0.3);
  CHECK(is_on_surface(meshed));
}

TEST_CASE("acute corners of noise move along a crease, those of clean creases stay") {
  constexpr double h = 0.1;
  for (const double roughness : {0.0, 0.016}) {
    const ShellOutcome outcome = *mesh_surface(grooved_disc(roughness), {.size = h});
    const auto& points = outcome.mesh.points;
    const Vec3 nearest = *std::min_element(points.begin(), points.end(), [](Vec3 a, Vec3 b) {
      return squared_length(a) < squared_length(b);
    });
    const bool rough = roughness > 0;
    INFO("eta " << shell_quality(outcome.mesh).eta_min << " moved " << length(nearest));
    CHECK(outcome.report.shape.eased == (rough ? 1 : 0));
    CHECK((length(nearest) > 0) == rough);
    CHECK(length(nearest) < 0.23 * h * (1 + 1e-9));
    CHECK(std::abs(nearest.z) < 1e-12);
    CHECK(std::abs(nearest.y) ==
          Approx(nearest.x * std::sin(groove_angle) / std::cos(groove_angle)).margin(1e-12));
    CHECK((shell_quality(outcome.mesh).eta_min > 0.3) == rough);
  }
}

TEST_CASE("a side that has nearly vanished grows again") {
  SurfaceSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  const double rest = GENERATE(1e-2, 1e-4, 1e-6);  // of the side
  Meshed meshed(soup, 0.1);
  const Charted charted = meshed.charted();
  const ShapeGround ground(charted);
  ShellMesh& mesh = meshed.mesh();
  std::vector<VertexRole> roles = vertex_roles(charted, ground.tracks, mesh);
  Index moved = none;
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 4 && moved == none; ++k) {
      const Index v = face[k], w = face[(k + 1) % 4];
      if (!mesh.is_free(v) || !mesh.is_free(w)) continue;
      if (mesh.places[v].triangle != mesh.places[w].triangle) continue;
      moved = v;
      for (int i = 0; i < 3; ++i)
        mesh.places[v].weight[i] =
            rest * mesh.places[v].weight[i] + (1 - rest) * mesh.places[w].weight[i];
      mesh.points[v] = point_at(meshed.outcome.surface, mesh.places[v]);
    }
  REQUIRE(moved != none);
  const SmoothOptions options;
  const auto lengthen_sides = [&] {
    SideLengthener sides(ground, options, mesh, roles);
    while (sides.step()) {
    }
    return sides.places();
  };
  CHECK(lengthen_sides() >= 1);
  for (Index f = 0; f < static_cast<Index>(mesh.faces.size()); ++f) {
    CHECK_FALSE(has_short_side(mesh, f, 0.05));
    CHECK(signed_eta(ground, mesh, f) > 0.3);
  }
  CHECK(is_on_surface(meshed));
  CHECK(lengthen_sides() == 0);
}

// Surfaces from end to end: the union conforms and has the topology of the surface, features are
// edges of the mesh, and cuts leave no trace that a person would see.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"
#include "shell/check.h"
#include "shell/mesh_surface.h"
#include "shell/place.h"
#include "shell/quality.h"
#include "shell/snapshot.h"
#include "shell/topology.h"
#include "support/meshed_surface.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

/// Every vertex is where its place on the surface says.
double largest_distance(const ShellOutcome& outcome) {
  double largest = 0;
  for (std::size_t v = 0; v < outcome.mesh.points.size(); ++v) {
    const SurfacePlace& place = outcome.mesh.places[v];
    Vec3 p{};
    for (int k = 0; k < 3; ++k)
      p += place.weight[k] * outcome.surface.points[outcome.surface.triangles[place.triangle][k]];
    largest = std::max(largest, distance(p, outcome.mesh.points[v]));
  }
  return largest;
}

}  // namespace

TEST_CASE("a flat square is meshed as in the plane") {
  const ShellOutcome outcome = meshed(soup_of(plane_square(5)), {.size = 0.1});
  CHECK(outcome.report.charts == 1);
  CHECK(outcome.report.quality.quads == 100);
  CHECK(outcome.report.quality.eta_min > 0.999);
}

TEST_CASE("a box keeps its edges and gets nothing but squares") {
  const ShellOutcome outcome = meshed(box_soup({1, 2, 1}, 3), {.size = 0.125});
  CHECK(outcome.report.faces == 6);
  CHECK(outcome.report.quality.quads == 2 * 64 + 4 * 128);
  CHECK(outcome.report.quality.eta_min > 0.999);
  CHECK(outcome.report.quality.valence_histogram[3] == 8);
  // Feature edges of the mesh lie on the box's edges: two coordinates at an end.
  for (const auto& [a, b] : outcome.mesh.edges) {
    const Vec3 p = midpoint(outcome.mesh.points[a], outcome.mesh.points[b]);
    const int at_end = (p.x == 0 || p.x == 1) + (p.y == 0 || p.y == 2) + (p.z == 0 || p.z == 1);
    CHECK(at_end == 2);
  }
}

TEST_CASE("an open pipe is one chart, and its seam vanishes") {
  const ShellOutcome outcome = meshed(soup_of(cylinder(48, 60, 0.5, 5)), {.size = 0.1});
  CHECK(outcome.report.quality.eta_mean > 0.99);
  CHECK(outcome.report.quality.four_valent_percent > 99);
  CHECK(largest_distance(outcome) < 1e-9);
}

TEST_CASE("the paper's chain runs in every chart, and L_p makes its quads better") {
  SurfaceOptions options{.size = 0.12, .method = Method::paper};
  const auto report = [&](int iterations, double norm) {
    options.iterations = iterations;
    options.norm = norm;
    auto outcome = mesh_surface(soup_of(torus(48, 24, 1, 0.4)), options);
    REQUIRE(outcome.has_value());
    CHECK(check_shell(outcome->surface, outcome->mesh).empty());
    return outcome->report;
  };
  const ShellReport start = report(0, 6), lloyd = report(60, 6);
  CHECK(lloyd.seams.windows == 0);
  CHECK(lloyd.quality.triangles == 0);
  CHECK(lloyd.quality.eta_mean > start.quality.eta_mean);
  CHECK(lloyd.quality.four_valent_percent > start.quality.four_valent_percent);
  CHECK(report(60, 2).hash != lloyd.hash);
}

TEST_CASE("a triangle that cannot be laid out flat ends in a plain reason") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 1);
  const auto first = static_cast<Index>(soup.points.size());
  soup.points.insert(soup.points.end(), {{3, 0, 0}, {4, 0, 0}, {4 + 5e-11, 0, 0}});
  soup.triangles.push_back({first, first + 1, first + 2});
  for (const int threads : {1, 2}) {
    const auto outcome = mesh_surface(soup, {.size = 0.5, .weld = 0}, {}, threads);
    REQUIRE(!outcome.has_value());
    CHECK(outcome.error().code == ErrorCode::no_valid_mesh);
    CHECK(outcome.error().message.find("laid out flat") != std::string::npos);
  }
}

TEST_CASE("threads change nothing, and can be told to stop") {
  const SurfaceSoup box = box_soup({1, 2, 1}, 3);
  const auto hash = [&](int threads) {
    return mesh_surface(box, {.size = 0.11}, {}, threads)->report.hash;
  };
  const std::uint64_t alone = hash(1);
  for (const int threads : {0, 2, 7}) CHECK(hash(threads) == alone);

  int asked = 0;
  const Monitor stop{[](const Progress& progress, void* count) {
                       return std::string(progress.stage) != "mesh" ||
                              ++*static_cast<int*>(count) < 5;
                     },
                     &asked};
  const auto stopped = mesh_surface(box, {.size = 0.11}, stop, 3);
  REQUIRE_FALSE(stopped.has_value());
  CHECK(stopped.error().code == ErrorCode::cancelled);
  CHECK(asked == 5);
}

TEST_CASE("closed surfaces are cut, meshed and made whole again", "[slow]") {
  for (const SurfaceMesh& mesh : {sphere(12), torus(48, 24, 1, 0.4)}) {
    SurfaceOptions options;
    options.size = std::sqrt(surface_area(mesh) / 1500);
    const ShellOutcome outcome = meshed(soup_of(mesh), options);
    CHECK(outcome.report.faces == 1);
    CHECK(outcome.report.quality.eta_mean > 0.9);
    CHECK(outcome.report.quality.four_valent_percent > 96);
    CHECK(outcome.report.quality.eta_min > 0.3);
    CHECK(largest_distance(outcome) < 1e-9);
  }
}

TEST_CASE("where a surface is thinner than the mesh size, the size gives way", "[slow]") {
  for (const double tube : {0.1, 0.03}) {
    const auto outcome = mesh_surface(soup_of(torus(96, 16, 1, tube)), {.size = 0.5});
    REQUIRE(outcome.has_value());
    CHECK(check_shell(outcome->surface, outcome->mesh).empty());
    CHECK(outcome->report.quality.triangles == 0);
  }
}

TEST_CASE("closed parts that are smaller than the mesh size get a closed mesh") {
  for (const double size : {1.5, 3.0, 40.0})
    for (const SurfaceSoup& soup : {box_soup({1, 1, 1}, 2), soup_of(sphere(8))}) {
      const auto outcome = mesh_surface(soup, {.size = size});
      REQUIRE(outcome.has_value());
      CHECK(check_shell(outcome->surface, outcome->mesh).empty());
      CHECK(outcome->report.quality.quads >= 6);
      CHECK(shell_topology(outcome->mesh.faces).euler == 2);
    }
}

TEST_CASE("the final check finds what is wrong with a mesh, and where") {
  const ShellOutcome good = meshed(box_soup({1, 1, 1}, 2), {.size = 0.25});
  const auto wrong = [&good](const ShellMesh& mesh) {
    const auto found = check_shell(good.surface, mesh);
    return !found.empty() && found[0].vertex != none;
  };
  ShellMesh twice = good.mesh;
  twice.faces.push_back(twice.faces[3]);
  twice.face.push_back(twice.face[3]);
  CHECK(wrong(twice));
  ShellMesh turned = good.mesh;
  std::swap(turned.faces[3][1], turned.faces[3][3]);
  CHECK(wrong(turned));
  ShellMesh open = good.mesh;
  open.faces.pop_back();
  open.face.pop_back();
  CHECK(wrong(open));
  ShellMesh bridged = good.mesh;  // an edge of a curve that no face has
  const auto last = static_cast<Index>(bridged.points.size()) - 1;
  bridged.edges.push_back({last, last + 1});
  bridged.sides.push_back({1, 1});
  CHECK(check_shell(good.surface, bridged).size() == 1);
  ShellMesh pinched = good.mesh;  // two vertices that no face has both of
  const Index from = pinched.faces[0][0], to = pinched.faces.back()[0];
  for (Face& face : pinched.faces) std::replace(face.begin(), face.end(), from, to);
  CHECK(!check_shell(good.surface, pinched).empty());
  CHECK(check_places(good.mesh.points, good.mesh.faces, 1e-12).empty());
  ShellMesh together = good.mesh;
  together.points[from] = together.points[to];
  CHECK(check_places(together.points, together.faces, 1e-12).size() == 1);
  const Index free = static_cast<Index>(
      std::find(good.mesh.pins.begin(), good.mesh.pins.end(), Pin::free) - good.mesh.pins.begin());
  ShellMesh fallen = good.mesh;
  fallen.points[free] = fallen.points[0];
  part_vertices(good.surface, fallen);
  CHECK(check_places(fallen.points, fallen.faces, 1e-12).empty());
}

TEST_CASE("surfaces that cannot be meshed are refused in words") {
  CHECK(mesh_surface({}).error().code == ErrorCode::empty);
  const auto large = mesh_surface(soup_of(plane_square(2)), {.size = 1e-5});
  REQUIRE(!large);
  CHECK(large.error().code == ErrorCode::too_many_elements);
  const auto wrong = mesh_surface(soup_of(plane_square(2)), {.feature_angle = 500});
  REQUIRE(!wrong);
  CHECK(wrong.error().code == ErrorCode::bad_option);
  for (const double size : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const auto none_such = mesh_surface(soup_of(plane_square(2)), {.size = size});
    REQUIRE(!none_such);
    CHECK(none_such.error().code == ErrorCode::bad_size);  // as in the plane
  }
  const auto no_choice = mesh_surface(soup_of(plane_square(2)), {.seeds = static_cast<Seeds>(9)});
  REQUIRE(!no_choice);
  CHECK(no_choice.error().code == ErrorCode::bad_option);
}

TEST_CASE("a surface run can be stopped, and repeats itself") {
  const SurfaceSoup soup = soup_of(sphere(6));
  int calls = 0;
  const Monitor stop{[](const Progress&, void* user) { return ++*static_cast<int*>(user) < 4; },
                     &calls};
  const auto stopped = mesh_surface(soup, {.size = 0.2}, stop);
  REQUIRE(!stopped);
  CHECK(stopped.error().code == ErrorCode::cancelled);
  const ShellOutcome a = meshed(soup, {.size = 0.2}), b = meshed(soup, {.size = 0.2});
  CHECK(a.mesh.points == b.mesh.points);
  CHECK(a.mesh.faces == b.mesh.faces);
}

TEST_CASE("seams and shape are made in many steps, which can be stopped and looked into") {
  auto mesher = SurfaceMesher::start(soup_of(torus(16, 32, 1, 0.4)), {.size = 0.2});
  REQUIRE(mesher.has_value());
  int steps[2] = {0, 0};
  SurfaceStage stage = mesher->stage();
  double share = 0;
  while (mesher->stage() != SurfaceStage::done) {
    if (mesher->stage() != stage) share = 0;
    stage = mesher->stage();
    CHECK((mesher->share() >= 0 && mesher->share() <= 1));
    if (stage > SurfaceStage::mesh) {
      CHECK(mesher->share() >= share);
      share = mesher->share();
      ++steps[stage == SurfaceStage::shape];
      // What is shown meanwhile is a mesh.
      CHECK(check_shell(mesher->surface(), mesher->mesh()).empty());
    }
    REQUIRE(mesher->step());
  }
  const Index windows = mesher->outcome().report.seams.windows;
  CHECK(windows > 4);
  CHECK(steps[0] > windows);  // one at most in each
  CHECK(steps[1] > 4);

  int left = 3;
  const auto in_seams = [](const Progress& progress, void* user) {
    return std::string(progress.stage) != "seams" || --*static_cast<int*>(user) > 0;
  };
  const auto stopped =
      mesh_surface(soup_of(torus(16, 32, 1, 0.4)), {.size = 0.2}, {in_seams, &left});
  REQUIRE(!stopped);
  CHECK(stopped.error().code == ErrorCode::cancelled);
  CHECK(left == 0);
}

TEST_CASE("a size larger than a body leaves its edges and corners") {
  for (const double size : {1.2, 2.0, 1000.0}) {
    const auto outcome = mesh_surface(box_soup({1, 1, 1}, 1), {.size = size});
    REQUIRE(outcome.has_value());
    CHECK(outcome->report.faces == 6);
    CHECK(outcome->mesh.faces.size() == 6);
    CHECK(outcome->report.distance.from_surface.max < 1e-9);
    const bool is_beyond = size > std::sqrt(3.0);
    REQUIRE(outcome->report.warnings.size() == (is_beyond ? 1 : 0));
    if (is_beyond) CHECK(outcome->report.warnings[0].code == ErrorCode::adapted);
  }
  SurfaceSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  const auto outcome = mesh_surface(triangle, {.size = 1000});
  REQUIRE(outcome.has_value());
  CHECK(outcome->report.distance.from_surface.max < 1e-9);
}

bool warns(const ShellOutcome& outcome, const char* of) {
  const auto& warnings = outcome.report.warnings;
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) {
    return warning.code == ErrorCode::bad_size && warning.message.find(of) != std::string::npos;
  });
}

/// A cone of needles with its base.
SurfaceSoup needle_cone(double radius, double height, int sides) {
  SurfaceSoup soup;
  soup.points = {{0, 0, height}, {0, 0, 0}};
  for (int i = 0; i < sides; ++i) {
    const SinCos direction = sin_cos(2 * pi * i / sides);
    soup.points.push_back({radius * direction.cos, radius * direction.sin, 0});
    soup.triangles.push_back({0, i + 2, (i + 1) % sides + 2});
    soup.triangles.push_back({1, (i + 1) % sides + 2, i + 2});
  }
  return soup;
}

TEST_CASE("a round body far below the size gets no face twice") {
  for (const double size : {1.0, 3.0, 1e3, 1e30}) {
    const ShellOutcome outcome = meshed(soup_of(sphere(8)), {.size = size});
    CHECK(outcome.mesh.faces.size() >= 6);
    CHECK(validate_faces(outcome.mesh.points, outcome.mesh.faces).empty());
  }
}

TEST_CASE("a seam inside another tube is no less looked after") {
  const SurfaceSoup outer = soup_of(cylinder(40, 20, 1, 6));
  const SurfaceSoup inner = soup_of(cylinder(40, 20, 0.9, 6));
  SurfaceSoup both = outer;
  const auto first = static_cast<Index>(outer.points.size());
  for (const auto& [a, b, c] : inner.triangles)
    both.triangles.push_back({first + a, first + b, first + c});
  both.points.insert(both.points.end(), inner.points.begin(), inner.points.end());
  const auto windows = [](const SurfaceSoup& soup) {
    return meshed(soup, {.size = 0.25}).report.seams.windows;
  };
  CHECK(windows(both) >= windows(outer) + windows(inner));
}

TEST_CASE("what a mesh cuts off or adds is told", "[slow]") {
  for (const double size : {0.1, 0.2, 0.4}) {
    const auto outcome = mesh_surface(needle_cone(0.5, 10, 31), {.size = size});
    REQUIRE(outcome.has_value());
    const auto& [to_surface, from_surface] = outcome->report.distance;
    CHECK(warns(*outcome, "cuts off") ==
          (from_surface.max > 0.5 * size && from_surface.max >= to_surface.max));
    CHECK(warns(*outcome, "stand out") ==
          (to_surface.max > 0.5 * size && to_surface.max > from_surface.max));
  }
}

TEST_CASE("quads with hardly any area are told") {
  for (const double width : {0.05, 1.0}) {
    SurfaceSoup splinter;
    splinter.points = {{0, 0, 0}, {10, -width, 0}, {10, width, 0}};
    splinter.triangles = {{0, 1, 2}};
    const ShellOutcome outcome = meshed(splinter, {.size = 0.5});
    CHECK(warns(outcome, "hardly any area") == (outcome.report.quality.eta_min < 0.02));
    CHECK(warns(outcome, "hardly any area") == (width < 0.1));
  }
}

TEST_CASE("quads with a side of hardly any length are told") {
  for (const double width : {0.002, 0.5}) {
    const ShellOutcome outcome = meshed(box_soup({2, 2, width}, 1), {.size = 0.5});
    CHECK(warns(outcome, "a side shorter than 0.01 of the longest") == (width < 0.005));
  }
}

TEST_CASE("a tip thinner than every size ends in a plain reason, not in ever smaller quads") {
  const auto outcome = mesh_surface(needle_cone(0.05, 5, 24), {.size = 0.1});
  if (outcome.has_value()) {
    CHECK(check_shell(outcome->surface, outcome->mesh).empty());
    CHECK(outcome->mesh.faces.size() < 5000);
  } else {
    CHECK(outcome.error().code == ErrorCode::no_valid_mesh);
  }
}

TEST_CASE("high effort goes on from the same charts, and leaves no more irregular vertices",
          "[slow]") {
  std::array<ShellOutcome, 2> outcomes;
  std::array<ShellMesh, 2> of_charts;
  for (const int high : {0, 1}) {
    SurfaceOptions options{.size = 0.1};
    if (high) options.effort = Effort::high;
    auto mesher = SurfaceMesher::start(soup_of(torus(60, 30, 1, 0.35)), options);
    REQUIRE(mesher.has_value());
    while (mesher->stage() < SurfaceStage::seams) REQUIRE(mesher->step().has_value());
    of_charts[high] = mesher->mesh();
    while (mesher->stage() != SurfaceStage::done) REQUIRE(mesher->step().has_value());
    outcomes[high] = mesher->outcome();
  }
  CHECK(of_charts[0].points == of_charts[1].points);
  CHECK(of_charts[0].faces == of_charts[1].faces);
  const auto irregular = [](const ShellOutcome& outcome) {
    const auto& valences = outcome.report.quality.valence_histogram;
    return std::accumulate(valences.begin(), valences.end(), 0) - valences[4];
  };
  CHECK(irregular(outcomes[1]) <= irregular(outcomes[0]));
  CHECK(outcomes[1].report.seams.windows > outcomes[0].report.seams.windows);
}

TEST_CASE("on noise, windows without a map are not looked for without end", "[slow]") {
  SurfaceMesh noisy = sphere(8);
  Rng rng(1);
  for (Vec3& p : noisy.points) p = rng.between(0.8, 1.2) * p;
  const auto outcome = mesh_surface(soup_of(noisy), {.size = 0.25});
  REQUIRE(outcome.has_value());
  const double triangles = noisy.triangle_count();
  const double most = 800 * (triangles + 1000);
  CHECK(outcome->report.seams.in_vain > most);  // the noise is such
  CHECK(outcome->report.seams.in_vain <= most + triangles);
}

TEST_CASE("surfaces beyond the range of calculation are refused as such") {
  for (const double scale : {1e-200, 1e-40, 1e40, 1e99}) {
    const auto outcome = mesh_surface(box_soup({scale, scale, scale}, 1), {.size = 0.5 * scale});
    REQUIRE(!outcome.has_value());
    CHECK(outcome.error().code == ErrorCode::lost_precision);
  }
  for (const double scale : {1e-29, 1e28}) {
    const auto outcome = mesh_surface(box_soup({scale, scale, scale}, 1), {.size = 0.5 * scale});
    REQUIRE(outcome.has_value());
    CHECK(outcome->mesh.faces.size() == 24);
  }
}

TEST_CASE("the cells of the chart that is meshed cover it, in its plane and on the surface") {
  auto mesher = SurfaceMesher::start(box_soup({1, 2, 1}, 3), {.size = 0.25});
  REQUIRE(mesher.has_value());
  CHECK(chart_cell_layer(*mesher).chart == none);
  std::vector<char> seen;
  while (mesher->stage() != SurfaceStage::done) {
    REQUIRE(mesher->step());
    const ChartCellLayer layer = chart_cell_layer(*mesher);
    const Csr<Vec2>& cells = layer.plane.polygons;
    REQUIRE(layer.points.size() == cells.values.size());
    CHECK((mesher->charts() != nullptr || layer.chart == none));
    if (cells.rows() == 0) continue;
    seen.resize(mesher->atlas().charts.size());
    seen[layer.chart] = 1;
    double area = 0;
    for (Index i = 0; i < cells.rows(); ++i) {
      const auto row = cells.row(i);
      for (std::size_t k = 1; k + 1 < row.size(); ++k)
        area += 0.5 * cross(row[k] - row[0], row[k + 1] - row[0]);
    }
    double whole = 0;
    for (const Index t : mesher->atlas().charts[layer.chart].triangles) {
      const auto [a, b, c] = mesher->surface().triangles[t];
      const auto& p = mesher->surface().points;
      whole += 0.5 * length(cross(p[b] - p[a], p[c] - p[a]));
    }
    CHECK(area == Approx(whole).epsilon(1e-9));
    // A box is flat in pieces: lengths stay as they are.
    CHECK(distance(layer.points[1], layer.points[0]) ==
          Approx(length(cells.values[1] - cells.values[0])).epsilon(1e-9));
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) ==
        static_cast<std::ptrdiff_t>(mesher->atlas().charts.size()));
}

TEST_CASE("a hole next to nothing wide ends no run in an endless walk round it") {
  for (const double e : {1e-200, 1e-59, 1e-50}) {
    SurfaceSoup soup;
    soup.points = {{e, 0, 0}, {0, e, 0}, {-e, -e, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
    soup.triangles = {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}};
    const auto outcome = mesh_surface(soup, {.size = 0.3, .weld = 0});
    if (outcome) CHECK(check_shell(outcome->surface, outcome->mesh).empty());
  }
}

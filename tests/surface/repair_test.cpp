// Repair: every defect is mended or cut, counted, and what comes out is a surface.
#include "surface/repair.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "support/surface_checks.h"
#include "support/surface_shapes.h"
#include "surface/bodies.h"
#include "surface/repair_warnings.h"

using namespace lpq;
using namespace lpq_test;

namespace {

RepairedSurface repaired(const SurfaceSoup& soup, RepairOptions options = {}) {
  auto result = repair_surface(soup, options);
  INFO((result ? std::string() : result.error().message));
  REQUIRE(result.has_value());
  check_surface(result->mesh);
  return *std::move(result);
}

ErrorCode refused(const SurfaceSoup& soup) {
  const auto result = repair_surface(soup);
  REQUIRE_FALSE(result.has_value());
  CHECK_FALSE(result.error().message.empty());
  return result.error().code;
}

SurfaceSoup soup_of(std::vector<Vec3> points, std::vector<Tri> triangles) {
  SurfaceSoup soup;
  soup.points = std::move(points);
  soup.triangles = std::move(triangles);
  return soup;
}

}  // namespace

TEST_CASE("a box of six loose sides becomes one closed surface") {
  const auto box = repaired(box_soup({1, 2, 3}, 4));
  CHECK(box.report.components == 1);
  CHECK(box.report.border_edges == 0);
  CHECK(box.report.turned_triangles == 0);
  const auto topology = topology_of(box.mesh);
  REQUIRE(topology.size() == 1);
  CHECK(topology[0].euler == 2);
  CHECK(volume_of(box.mesh) == Approx(6));
  CHECK(area_of(box.mesh.points, box.mesh.triangles) == Approx(22));
}

TEST_CASE("shuffled orientations become one, with the outside out") {
  SurfaceSoup soup = box_soup({1, 2, 3}, 4);
  Rng rng(3);
  for (Tri& t : soup.triangles)
    if (rng.below(2) == 1) std::swap(t[0], t[1]);
  const auto box = repaired(soup);
  CHECK(box.report.turned_triangles > 0);
  CHECK(box.report.conflict_edges == 0);
  CHECK(volume_of(box.mesh) == Approx(6));
}

TEST_CASE("a consistent orientation stays, even inside out") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 2);
  for (Tri& t : soup.triangles) std::swap(t[0], t[1]);
  CHECK(volume_of(repaired(soup).mesh) == Approx(-1));
}

TEST_CASE("a Moebius band is cut once; a ring is not") {
  const auto band = repaired(band_soup(12, 1));
  CHECK(band.report.conflict_edges > 0);
  const auto cut = topology_of(band.mesh);
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].euler == 1);
  CHECK(cut[0].loops == 1);
  const auto ring = repaired(band_soup(12, 0));
  CHECK(ring.report.conflict_edges == 0);
  CHECK(topology_of(ring.mesh)[0].loops == 2);
}

TEST_CASE("sheets that meet in an edge keep its points and get walls there") {
  const auto joint = repaired(soup_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  CHECK(joint.report.nonmanifold_edges == 1);
  CHECK(joint.report.nonmanifold_vertices == 0);
  CHECK(joint.report.border_edges == 6);
  CHECK(joint.mesh.vertex_count() == 5);
  CHECK(topology_of(joint.mesh).size() == 3);
}

TEST_CASE("cones that meet in a point are counted, and it stays one point") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 1);
  const auto count = static_cast<Index>(soup.points.size());
  for (Index v = 0; v < count; ++v) soup.points.push_back(soup.points[v] + Vec3{1, 1, 1});
  for (std::size_t t = 0; t < 12; ++t) {
    const Tri other = soup.triangles[t];
    soup.triangles.push_back({other[0] + count, other[1] + count, other[2] + count});
  }
  const auto pair = repaired(soup);
  CHECK(pair.report.nonmanifold_vertices == 1);
  CHECK(pair.report.nonmanifold_edges == 0);
  CHECK(pair.mesh.vertex_count() == 15);
  CHECK(pair.report.components == 2);
}

TEST_CASE("bodies that share a side stay two closed surfaces, however they are welded") {
  SurfaceSoup soup = touching_boxes(3);
  for (const double weld : {0.0, 1e-10, 1e-7}) {
    const auto pair = repaired(soup, {.weld = weld});
    CHECK(pair.report.components == 2);
    CHECK(pair.report.border_edges + pair.report.nonmanifold_edges == 0);
    CHECK(pair.report.duplicate_triangles == 0);
    CHECK(pair.mesh.triangles.size() == soup.triangles.size());
    CHECK(volume_of(pair.mesh) == Approx(3));
    for (const Tri& t : pair.mesh.triangles)
      for (const Index v : t) CHECK(pair.mesh.body[v] == pair.mesh.body[t[0]]);
    CHECK(pair.body_names == std::vector<std::string>{"body 1", "body 2"});
  }
  soup.body.clear();
  const auto one = repaired(soup);
  CHECK(one.report.nonmanifold_edges + one.report.duplicate_triangles > 0);
  CHECK(one.mesh.body.empty());
}

TEST_CASE("a point that two bodies have becomes two") {
  SurfaceSoup soup = soup_of(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 2}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
  soup.body = {0, 0, 0, 0, 1, 1, 1, 1};
  const auto pair = repaired(soup);
  CHECK(pair.body_names == std::vector<std::string>(2));  // unnamed
  CHECK(pair.report.components == 2);
  CHECK(pair.report.border_edges + pair.report.nonmanifold_edges == 0);
  CHECK(pair.report.duplicate_triangles == 0);
  CHECK(pair.mesh.vertex_count() == 8);
  CHECK(pair.vertex_of_point.size() == 5);
  CHECK(volume_of(pair.mesh) == Approx(2.0 / 6));
}

TEST_CASE("a point that very many bodies have becomes one for each") {
  constexpr Index bodies = 20'000;
  SurfaceSoup soup;
  soup.points = {{0, 0, 0}};
  for (Index b = 0; b < bodies; ++b) {
    const double x = 1 + b / 4, far = b % 4;
    const auto first = static_cast<Index>(soup.points.size());
    for (const Vec3 p : {Vec3{x, far, 1}, Vec3{x + 0.5, far, 1}, Vec3{x, far + 0.5, 1}})
      soup.points.push_back(p);
    for (const Tri& t : {Tri{0, first + 1, first}, Tri{0, first + 2, first + 1},
                         Tri{0, first, first + 2}, Tri{first, first + 1, first + 2}}) {
      soup.triangles.push_back(t);
      soup.body.push_back(b);
    }
  }
  const auto all = repaired(soup);
  CHECK(all.report.components == bodies);
  CHECK(all.report.border_edges + all.report.nonmanifold_edges == 0);
  CHECK(all.mesh.vertex_count() == 4 * bodies);
  for (const Tri& t : all.mesh.triangles)
    for (const Index v : t) REQUIRE(all.mesh.body[v] == all.mesh.body[t[0]]);
}

TEST_CASE("loose sheets are one body, closed ones stay, and so do those with points of their own") {
  SurfaceSoup box = box_soup({1, 1, 1}, 2), soup = as_bodies({box, box, box});
  // The sides of the third are sheets: 8 triangles each.
  for (std::size_t t = 2 * box.triangles.size(); t < soup.triangles.size(); ++t)
    soup.body[t] = static_cast<Index>(2 + (t - 2 * box.triangles.size()) / 8);
  soup.body_names = {"a", "b", "c", "d", "e", "f", "g", "h"};
  join_loose_bodies(soup);
  CHECK(soup.body_names == std::vector<std::string>{"a", "b", "c"});
  const auto three = repaired(soup);
  CHECK(three.report.components == 3);
  CHECK(three.report.border_edges == 0);
  soup = as_bodies({box, box});
  soup.triangles.push_back({0, static_cast<Index>(box.points.size()), 1});
  soup.body.push_back(0);
  join_loose_bodies(soup);
  CHECK(soup.body_names == std::vector<std::string>{"body 1"});
}

TEST_CASE("duplicates, repeated corners and points without triangles go") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 2);
  const std::size_t count = soup.triangles.size();
  soup.triangles.push_back(soup.triangles[5]);
  soup.triangles.push_back({soup.triangles[7][1], soup.triangles[7][0], soup.triangles[7][2]});
  soup.triangles.push_back({3, 3, 4});
  soup.points.push_back({9, 9, std::nan("")});
  const auto box = repaired(soup);
  CHECK(box.report.duplicate_triangles == 2);
  CHECK(box.report.collapsed_triangles == 1);
  CHECK(box.report.unused_points == 1);
  CHECK(box.mesh.triangles.size() == count);
}

TEST_CASE("points whose distance is too small for a number are equal") {
  constexpr double e = 1e-200;
  const SurfaceSoup ring =
      soup_of({{e, 0, 0}, {0, e, 0}, {-e, -e, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
              {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}});
  const auto disk = repaired(ring, {.weld = 0});
  CHECK(disk.mesh.vertex_count() == 4);
  CHECK(topology_of(disk.mesh)[0].loops == 1);
}

TEST_CASE("nearly equal points are welded when asked") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 3);
  Rng rng(5);
  for (Vec3& p : soup.points)
    p += {rng.between(-1e-8, 1e-8), rng.between(-1e-8, 1e-8), rng.between(-1e-8, 1e-8)};
  CHECK(repaired(soup).report.components == 6);
  const auto welded = repaired(soup, {.weld = 1e-7});
  CHECK(welded.report.components == 1);
  CHECK(welded.report.border_edges == 0);
  CHECK(welded.mesh.vertex_count() == 6 * 9 + 2);
}

TEST_CASE("slits without width are closed, narrow sheets and sheets side by side stay") {
  // A box, a vertex of which is two: one for the triangles on one side of it, one for the others.
  const SurfaceMesh box = repaired(box_soup({1, 2, 1}, 4)).mesh;
  const SurfaceSoup soup = soup_of(box.points, box.triangles);
  const auto torn = static_cast<Index>(
      std::find(soup.points.begin(), soup.points.end(), Vec3{0.5, 1, 1}) - soup.points.begin());
  const auto other = static_cast<Index>(soup.points.size());
  REQUIRE(torn < other);
  for (const double gap : {1e-8, 1e-7, 1e-3}) {
    SurfaceSoup part = soup;
    part.points.push_back(soup.points[torn] + Vec3{gap, 0, 0});
    for (Tri& t : part.triangles) {
      const Vec3 centre = (1.0 / 3) * (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]);
      if (centre.x > 0.5) std::replace(t.begin(), t.end(), torn, other);
    }
    const auto result = repaired(part);
    const bool closes = gap < 1e-6;
    CHECK(result.report.slit_points == closes);
    CHECK(result.report.border_edges == (closes ? 0 : 4));
    CHECK(result.mesh.triangles.size() == part.triangles.size());
    CHECK(repaired(part, {.weld = 0}).report.slit_points == 0);
  }
  SurfaceSoup strip = band_soup(12, 0);
  for (Vec3& p : strip.points) p = 1e-8 * p;
  const Index low = static_cast<Index>(strip.points.size());
  strip.points.insert(strip.points.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  strip.triangles.push_back({low, low + 1, low + 2});  // large beside it
  strip.points.insert(strip.points.end(), {{0, 0, 1e-8}, {1, 0, 1e-8}, {0, 1, 1e-8}});
  strip.triangles.push_back({low + 3, low + 4, low + 5});
  const auto result = repaired(strip);
  CHECK(result.report.slit_points == 0);
  CHECK(result.mesh.triangles.size() == strip.triangles.size());
}

TEST_CASE("points that hang on edges of another sheet are shared") {
  // A square below an edge from 0 to 4 and three triangles above it, whose points divide the edge
  // elsewhere: 1, 2 | 2.5 | 3; the point at 2.5 is the lower sheet's.
  const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {4, -3, 0}, {0, -3, 0}, {2.5, 0, 0},
                                 {1, 0, 0}, {2, 0, 0}, {3, 0, 0},  {0, 3, 0},  {4, 3, 0}};
  const std::vector<Tri> triangles{{0, 3, 4}, {3, 2, 4}, {2, 1, 4}, {0, 5, 8},
                                   {5, 6, 8}, {6, 7, 8}, {7, 9, 8}, {7, 1, 9}};
  for (const double off : {0.0, 1e-6, 1e-3}) {
    SurfaceSoup soup = soup_of(points, triangles);
    soup.points[6].z = off;
    const auto result = repaired(soup);
    const bool meets = off < 1e-5;
    CHECK(result.report.hanging_points == (meets ? 4 : 2));
    CHECK(result.mesh.triangles.size() == triangles.size() + (meets ? 4 : 2));
    CHECK(area_of(result.mesh.points, result.mesh.triangles) == Approx(24));
    const auto wide = repaired(soup, {.weld = 2e-4});
    CHECK(wide.report.hanging_points == 4);
    CHECK(wide.report.border_edges == 3 + 3);
    CHECK(repaired(soup, {.weld = 0}).report.hanging_points == 0);
  }
}

TEST_CASE("triangles whose points are rounded one by one are put together") {
  const SurfaceSoup box = box_soup({1, 2, 3}, 4);
  for (const double error : {3e-8, 3e-6, 3e-3}) {
    Rng rng(7);
    const auto off = [&] { return error * (rng.unit() - 0.5); };
    SurfaceSoup soup;
    for (const Tri& t : box.triangles) {
      const Index first = static_cast<Index>(soup.points.size());
      for (const Index v : t) soup.points.push_back(box.points[v] + Vec3{off(), off(), off()});
      soup.triangles.push_back({first, first + 1, first + 2});
    }
    const auto result = repaired(soup);
    const bool is_rounding = error < 1e-5;
    CHECK((result.report.rounding > 0) == is_rounding);
    const auto count = static_cast<Index>(box.triangles.size());
    CHECK(result.report.border_edges == (is_rounding ? 0 : 3 * count));
    CHECK(result.mesh.triangles.size() == box.triangles.size());
    CHECK(repaired(soup, {.weld = 0}).report.components == count);
  }
}

TEST_CASE("of many borders beside each other the gap to the next one is told") {
  const double gap = 8e-4;
  SurfaceSoup soup;
  for (int plate = 0; plate < 20; ++plate) {
    const auto first = static_cast<Index>(soup.points.size());
    const double z = gap * plate;
    for (const Vec3 p : {Vec3{0, 0, z}, Vec3{1, 0, z}, Vec3{1, 1, z}, Vec3{0, 1, z}})
      soup.points.push_back(p);
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.triangles.push_back({first, first + 2, first + 3});
  }
  const auto plates = repaired(soup);
  CHECK(plates.report.gap.points > 0);
  CHECK(plates.report.gap.width < 2 * gap);
  CHECK(plates.report.closing_weld <= 0.01);
}

TEST_CASE("gaps between borders are told, with the weld that closes them") {
  const SurfaceSoup box = box_soup({1, 2, 3}, 4);
  for (const double gap : {1e-5, 1e-3, 0.1}) {
    SurfaceSoup soup = box;
    const std::size_t per_side = soup.triangles.size() / 6;
    const auto first = static_cast<Index>(soup.points.size());
    soup.points.insert(soup.points.end(), box.points.begin(), box.points.end());
    for (std::size_t v = first; v < soup.points.size(); ++v) soup.points[v] += Vec3{gap, gap, gap};
    for (std::size_t t = 0; t < per_side; ++t)
      for (Index& v : soup.triangles[t]) v += first;
    const auto open = repaired(soup);
    CHECK(open.report.border_edges == 2 * 16);
    CHECK(open.report.gap.points == (gap < 0.1 ? 16 : 0));
    CHECK(repair_warnings(open.report).size() == (gap < 0.1 ? 1 : 0));
    if (gap == 0.1) continue;
    CHECK(open.report.gap.width == Approx(gap * std::sqrt(3.0)));
    const auto closed = repaired(soup, {.weld = open.report.closing_weld});
    CHECK(closed.report.border_edges == 0);
    CHECK(closed.report.gap.points == 0);
  }
}

TEST_CASE("a closed body whose sides are divided differently is closed") {
  // Each side of the box comes with a grid of its own, 1 to 6 steps: only the corners are shared.
  SurfaceSoup soup;
  for (int side = 0; side < 6; ++side) {
    const SurfaceSoup box = box_soup({1, 1, 1}, side + 1);
    const auto first = static_cast<Index>(soup.points.size());
    soup.points.insert(soup.points.end(), box.points.begin(), box.points.end());
    const std::size_t per_side = box.triangles.size() / 6;
    for (std::size_t t = side * per_side; t < (side + 1) * per_side; ++t)
      soup.triangles.push_back(
          {box.triangles[t][0] + first, box.triangles[t][1] + first, box.triangles[t][2] + first});
  }
  const auto result = repaired(soup);
  CHECK(result.report.components == 1);
  CHECK(result.report.border_edges == 0);
  CHECK(result.report.hanging_points > 0);
  CHECK(volume_of(result.mesh) == Approx(1));
  CHECK(area_of(result.mesh.points, result.mesh.triangles) == Approx(6));
}

TEST_CASE("flat triangles go and leave no gap") {
  // A square whose lower edge has points that only flat triangles know, and a sheet below it.
  const auto square = repaired(
      soup_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 0, 0}, {3, 0, 0}, {2, -3, 1}},
              {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {4, 5, 1}, {0, 6, 4}, {4, 6, 5}, {5, 6, 1}}));
  CHECK(square.report.flat_triangles == 2);
  CHECK(square.report.flat_left == 0);
  CHECK(square.report.nonmanifold_edges == 0);
  CHECK(square.report.components == 1);
  const auto topology = topology_of(square.mesh);
  REQUIRE(topology.size() == 1);
  CHECK(topology[0].euler == 1);
  CHECK(square.report.border_edges == 5);
}

TEST_CASE("flat triangles in heaps, at borders and between more than two sheets") {
  Rng rng(11);
  for (int round = 0; round < 200; ++round) {
    // Points on one line, random triangles among them, and random sheets that hang on the line.
    SurfaceSoup soup;
    const auto on_line = static_cast<Index>(4 + rng.below(6));
    for (Index i = 0; i < on_line; ++i) soup.points.push_back({double(i), 0, 0});
    for (int i = 0; i < 4; ++i)
      soup.points.push_back({rng.between(0, 5), rng.between(1, 2), rng.between(-1, 1)});
    const auto any = [&](Index n) { return static_cast<Index>(rng.below(n)); };
    for (int i = 0; i < 8; ++i)
      soup.triangles.push_back({any(on_line), any(on_line), any(on_line)});
    for (int i = 0; i < 6; ++i)
      soup.triangles.push_back({any(on_line), any(on_line), on_line + any(4)});
    soup.triangles.push_back({0, 1, on_line});
    const auto heap = repaired(soup);
    CHECK(heap.report.flat_left == 0);
    CHECK(area_of(heap.mesh.points, heap.mesh.triangles) <=
          area_of(soup.points, soup.triangles) * (1 + 1e-12));
  }
}

TEST_CASE("what cannot be a surface is refused") {
  CHECK(refused({}) == ErrorCode::empty);
  CHECK(refused(soup_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})) == ErrorCode::zero_area);
  CHECK(refused(soup_of({{1, 1, 1}}, {{0, 0, 0}})) == ErrorCode::zero_area);
  CHECK(refused(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}})) == ErrorCode::parse_error);
  CHECK(refused(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, -1}})) ==
        ErrorCode::parse_error);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(refused(soup_of({{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}, {{0, 1, 2}})) ==
        ErrorCode::non_finite);
  CHECK(refused(soup_of({{0, 0, 0}, {1e200, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})) ==
        ErrorCode::too_large);
}

TEST_CASE("a point beside which all others are one is named, not searched around") {
  std::vector<Vec3> points;
  std::vector<Tri> triangles;
  for (Index k = 0; k < 20000; ++k) points.push_back({1.0 * (k % 100), 1.0 * (k / 100), 0});
  for (Index k = 0; k + 101 < 20000; ++k) triangles.push_back({k, k + 1, k + 101});
  points[777].z = 1e20;
  const auto repaired = repair_surface(soup_of(points, triangles));
  REQUIRE(!repaired.has_value());
  CHECK(repaired.error().code == ErrorCode::lost_precision);
  CHECK(repaired.error().message.find("(77, 7, 1e+20)") != std::string::npos);
}

TEST_CASE("sizes follow their points, the least of those that are welded") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 2);  // six sides of nine points each
  soup.sizes.assign(soup.points.size(), 0);
  for (std::size_t p = 0; p < soup.points.size(); ++p)
    if (soup.points[p].x == 1) soup.sizes[p] = 0.1 + 0.001 * static_cast<double>(p);
  const auto box = repaired(soup);
  REQUIRE(box.sizes.size() == box.mesh.points.size());
  for (std::size_t p = 0; p < soup.points.size(); ++p) {
    const double size = box.sizes[box.vertex_of_point[p]];
    CHECK((size > 0) == (soup.points[p].x == 1));
    CHECK(size <= soup.sizes[p]);
  }
  for (const double wrong : {-1.0, std::numeric_limits<double>::infinity()}) {
    soup.sizes[3] = wrong;
    CHECK(refused(soup) == ErrorCode::bad_size);
  }
  soup.sizes.pop_back();
  CHECK(refused(soup) == ErrorCode::bad_size);
}

TEST_CASE("groups and bodies are one for each triangle, and no others") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 1);
  const std::size_t count = soup.triangles.size();
  const std::vector<std::vector<Index>> wrong{std::vector<Index>(count - 1, 0),
                                              std::vector<Index>(count, -1),
                                              std::vector<Index>(count, 2'000'000'000)};
  for (const std::vector<Index>& labels : wrong) {
    SurfaceSoup grouped = soup, bodied = soup;
    grouped.group = labels;
    bodied.body = labels;
    CHECK(refused(grouped) == ErrorCode::parse_error);
    CHECK(refused(bodied) == ErrorCode::parse_error);
  }
}

TEST_CASE("labels are below the number of names, and without names as many as they say") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 1);
  soup.group = soup.body = std::vector<Index>(soup.triangles.size(), 0);
  soup.group[3] = soup.body[3] = 2;
  const auto unnamed = repaired(soup);
  CHECK(unnamed.group_names.size() == 3);
  CHECK(unnamed.body_names.size() == 3);

  SurfaceSoup grouped = soup, bodied = soup;
  grouped.group_names = {"a", "b"};
  bodied.body_names = {"a", "b"};
  CHECK(refused(grouped) == ErrorCode::parse_error);
  CHECK(refused(bodied) == ErrorCode::parse_error);
  grouped.group_names = bodied.body_names = {"a", "b", "c"};
  CHECK(repaired(grouped).group_names == grouped.group_names);
  CHECK(repaired(bodied).body_names == bodied.body_names);
}

TEST_CASE("groups follow their triangles") {
  SurfaceSoup soup = box_soup({1, 1, 1}, 2);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    soup.group.push_back(static_cast<Index>(t / 8));
  soup.group_names = {"a", "b", "c", "d", "e", "f"};
  soup.triangles[3] = {0, 0, 0};
  const auto box = repaired(soup);
  CHECK(box.group_names == soup.group_names);
  CHECK(std::count(box.mesh.group.begin(), box.mesh.group.end(), 0) == 7);
  CHECK(std::count(box.mesh.group.begin(), box.mesh.group.end(), 5) == 8);
}

// Curves and their 1D mesh.
#include "surface/curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rng.h"
#include "catch.h"
#include "numerics/elementary.h"
#include "support/surface_checks.h"
#include "support/surface_curves.h"
#include "support/surface_shapes.h"
#include "surface/balance_counts.h"
#include "surface/face_borders.h"
#include "surface/repair.h"
#include "surface/side_balance.h"

using namespace lpq;
using namespace lpq_test;

namespace {

struct Curves {
  SurfaceMesh mesh;
  std::vector<double> size;
  SurfaceFeatures features;
  SurfaceCurves curves;
  CurveMesh nodes;
};

template <class Size>
Curves curves_by(const SurfaceSoup& soup, Size&& size, FeatureOptions options = {}) {
  auto surface = repair_surface(soup);
  REQUIRE(surface.has_value());
  Curves all;
  all.mesh = std::move(surface->mesh);
  for (const Vec3 p : all.mesh.points) all.size.push_back(size(p));
  all.features = find_features(all.mesh, all.size, options);
  all.curves = trace_curves(all.mesh, all.features);
  auto nodes = mesh_curves(all.mesh, all.features, all.curves, all.size);
  REQUIRE(nodes.has_value());
  all.nodes = *std::move(nodes);
  check_curves(all.mesh, all.features, all.curves);
  check_curve_mesh(all.mesh, all.features, all.curves, all.nodes);
  return all;
}
Curves curves_of(const SurfaceSoup& soup, double size, FeatureOptions options = {}) {
  return curves_by(
      soup, [size](Vec3) { return size; }, options);
}

/// A plate with 2 x `width` straight sides and quarters of circles of radius r at its corners.
SurfaceSoup rounded_plate(double width, double r) {
  SurfaceSoup soup;
  constexpr int pieces = 12;
  soup.points.push_back({});
  for (int corner = 0; corner < 4; ++corner)
    for (int k = 0; k <= pieces; ++k) {
      const double angle = (corner + double(k) / pieces) * (pi / 2);
      const double x = corner == 1 || corner == 2 ? -width : width, y = corner < 2 ? width : -width;
      soup.points.push_back({x + r * std::cos(angle), y + r * std::sin(angle), 0});
    }
  const auto n = static_cast<Index>(soup.points.size()) - 1;
  for (Index k = 0; k < n; ++k) soup.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
  return soup;
}

/// A ring with round slots from outside, a tooth between every two.
SurfaceSoup slotted_ring(int slots, double outer, double inner, double depth) {
  SurfaceSoup soup;
  const auto add = [&](double turns, double r) {
    for (const double radius : {r, inner})
      soup.points.push_back(
          {radius * std::cos(2 * pi * turns), radius * std::sin(2 * pi * turns), 0});
  };
  constexpr int pieces = 12;
  for (int slot = 0; slot < slots; ++slot) {
    for (int k = 0; k < pieces; ++k) {
      const double angle = pi * k / pieces;
      add((slot + 0.25 * (1 - std::cos(angle))) / slots, outer - depth * std::sin(angle));
    }
    for (int k = 0; k < pieces; ++k) add((slot + 0.5 + 0.5 * k / pieces) / slots, outer);
  }
  const auto n = static_cast<Index>(soup.points.size());
  for (Index a = 0; a < n; a += 2) {
    const Index b = (a + 2) % n;
    soup.triangles.push_back({a, b, a + 1});
    soup.triangles.push_back({a + 1, b, b + 1});
  }
  return soup;
}

/// A rectangle with a rectangular hole, turned somehow; the hole's corners come first where `first`
/// says so.
SurfaceSoup frame_soup(double width, double height, double across, std::size_t first) {
  SurfaceSoup soup;
  const Vec3 x{0.36, 0.48, -0.8}, y{0.8, -0.6, 0};
  for (const double in : {0.0, across})
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t corner = in > 0 ? (first + k) % 4 : k;
      const double right = corner == 1 || corner == 2 ? width - in : in;
      const double up = corner >= 2 ? height - in : in;
      soup.points.push_back(right * x + up * y);
    }
  for (Index k = 0; k < 4; ++k) {
    const auto inside = [&](Index corner) {
      return static_cast<Index>(4 + (corner + 4 - static_cast<Index>(first)) % 4);
    };
    const Index next = (k + 1) % 4;
    soup.triangles.push_back({k, next, inside(next)});
    soup.triangles.push_back({k, inside(next), inside(k)});
  }
  return soup;
}

Index edge_count(const Curves& all, Index c) {
  return static_cast<Index>(all.nodes.nodes.row(c).size()) - 1;
}

std::vector<double> steps_of(const Curves& all, double h) {
  std::vector<double> steps;
  for (Index c = 0; c < all.curves.count(); ++c) {
    double length = 0;
    const auto vertices = all.curves.vertices.row(c);
    for (std::size_t k = 1; k < vertices.size(); ++k)
      length += distance(all.mesh.points[vertices[k - 1]], all.mesh.points[vertices[k]]);
    steps.push_back(length / h);
  }
  return steps;
}

CountSums sums_of(const Curves& all, double h) {
  return side_balances(all.mesh, all.features, all.curves, steps_of(all, h));
}

std::vector<FaceBorder> borders_of(const Curves& all, double h) {
  return face_borders(all.mesh, all.features, all.curves, steps_of(all, h));
}

Index value_of(const Curves& all, const CountSums& sums, Index s) {
  Index sum = sums.constant[s];
  for (const CountTerm& term : sums.terms.row(s)) sum += term.factor * edge_count(all, term.curve);
  return sum;
}

}  // namespace

TEST_CASE("a box: twelve curves of equal, even steps") {
  const auto box = curves_of(box_soup({1, 2, 3}, 5), 0.1);
  REQUIRE(box.curves.count() == 12);
  CHECK(box.nodes.points.size() == 8 + 4 * (9 + 19 + 29));
  for (Index c = 0; c < 12; ++c) {
    CHECK(edge_count(box, c) % 2 == 0);
    CHECK(box.curves.faces.row(c).size() == 2);
    const auto row = box.nodes.nodes.row(c);
    for (std::size_t k = 1; k < row.size(); ++k)
      CHECK(distance(box.nodes.points[row[k - 1]], box.nodes.points[row[k]]) == Approx(0.1));
  }
}

TEST_CASE("steps are equal in int ds/h where the size varies") {
  const auto size = [](Vec3 p) { return 0.02 + 0.05 * p.x + 0.03 * p.y * p.y; };
  const auto box = curves_by(box_soup({1, 2, 3}, 40), size);
  for (Index c = 0; c < box.curves.count(); ++c) {
    const auto row = box.nodes.nodes.row(c);
    double least = 1e9, most = 0;
    for (std::size_t k = 1; k < row.size(); ++k) {
      const Vec3 a = box.nodes.points[row[k - 1]], b = box.nodes.points[row[k]];
      double steps = 0;  // midpoint rule along the straight side
      for (int i = 0; i < 100; ++i)
        steps += distance(a, b) / 100 / size(a + ((i + 0.5) / 100) * (b - a));
      least = std::min(least, steps);
      most = std::max(most, steps);
    }
    CHECK(most < least * 1.02);
    CHECK(std::abs(most - 1) < 0.2);  // opposite sides with other sizes bear the difference
  }
}

TEST_CASE("closed curves get four edges or more, and are even") {
  const double none_of_it = 180;
  for (const double h : {0.05, 0.3, 2.0, 100.0}) {
    const auto ring = curves_of(band_soup(24, 0), h, {.angle = none_of_it});
    REQUIRE(ring.curves.count() == 2);
    for (Index c = 0; c < 2; ++c) {
      CHECK(ring.curves.is_loop[c] == 1);
      CHECK(edge_count(ring, c) >= 4);
      CHECK(edge_count(ring, c) % 2 == 0);
    }
  }
}

TEST_CASE("opposite sides of skew boxes have as many edges") {
  Rng rng(3);
  for (int round = 0; round < 40; ++round) {
    SurfaceSoup soup = box_soup({rng.between(1, 2), rng.between(1, 2), rng.between(1, 2)}, 3);
    const double taper = rng.between(-0.1, 0.1), lean = rng.between(-0.1, 0.1);
    for (Vec3& p : soup.points) p = {p.x * (1 + taper * p.z), p.y * (1 + lean * p.x), p.z};
    const double h = rng.between(0.05, 0.5);
    const auto box = curves_of(soup, h);
    REQUIRE(box.curves.count() == 12);
    const CountSums sums = sums_of(box, h);
    CHECK(sums.terms.rows() == 12);
    for (Index s = 0; s < sums.terms.rows(); ++s) {
      CHECK(sums.terms.row(s).size() == 2);
      CHECK(value_of(box, sums, s) == 0);
    }
  }
}

TEST_CASE("both ends of a pipe have as many edges") {
  SurfaceSoup soup = band_soup(24, 0);
  for (Vec3& p : soup.points) {
    const double away = length(p), r = 1 + 0.1 * away;  // a cone instead of a plane ring
    p = {p.x / away * r, p.y / away * r, 2 * away};
  }
  for (const double h : {0.05, 0.1, 0.17, 0.3}) {
    const auto pipe = curves_of(soup, h, {.angle = 180});
    REQUIRE(pipe.curves.count() == 2);
    CHECK(edge_count(pipe, 0) == edge_count(pipe, 1));
  }
}

TEST_CASE("a ring with slots: what the teeth and the slots have along it, the inside has") {
  constexpr Index slots = 16;
  for (const double h : {0.7, 0.8, 0.9, 1.0, 1.1}) {
    INFO(h);
    const auto ring = curves_of(slotted_ring(slots, 10, 8.2, 0.9), h);
    REQUIRE(ring.curves.count() == 2 * slots + 1);
    const CountSums sums = sums_of(ring, h);
    Index with_slots = 0;
    for (Index s = 0; s < sums.terms.rows(); ++s) {
      if (sums.constant[s] == 0) continue;
      ++with_slots;
      CHECK(std::abs(value_of(ring, sums, s)) <= 2);  // before: about twelve
      CHECK(std::abs(sums.constant[s]) % slots == 0);
    }
    CHECK(with_slots == 1);
    for (Index c = 0; c < ring.curves.count(); ++c)
      if (sums.bent[c] > 0) CHECK(edge_count(ring, c) == sums.bent[c]);
    CHECK(std::count(sums.bent.begin(), sums.bent.end(), 0) == slots + 1);
  }
}

TEST_CASE("a ring so small that its hole is one bend has as many edges outside as inside") {
  for (const double wider : {1.15, 1.3, 1.5})
    for (int round = 12; round <= 18; ++round) {  // inside, in mesh sizes
      INFO(wider << " " << round);
      const double r = round / (2 * pi);
      const auto ring = curves_of(slotted_ring(3, wider * r, r, 0), 1);
      REQUIRE(ring.curves.count() == 2);
      CHECK(edge_count(ring, 0) == edge_count(ring, 1));
    }
}

TEST_CASE("narrow rings have as many edges outside as inside, wide ones need not") {
  for (const double h : {0.5, 0.6, 1.6}) {
    const auto ring = curves_of(band_soup(24, 0), h);
    REQUIRE(ring.curves.count() == 2);
    CHECK(edge_count(ring, 0) == edge_count(ring, 1));
    CHECK(edge_count(ring, 0) >= 6);  // even where squares would fit the size better
  }
}

TEST_CASE("round the end of a thin wall every side has what is beside it inside") {
  Rng rng(29);
  int with_other_wishes = 0;
  for (int round = 0; round < 60; ++round) {
    const double width = rng.between(20, 60), height = rng.between(20, 60);
    const double across = rng.between(0.5, 3), h = rng.between(0.7 * across, 6 * across);
    INFO(width << " x " << height << ", " << across << " across, size " << h);
    if (std::abs(across / h - 0.5) < 0.02) continue;
    const auto frame = curves_of(frame_soup(width, height, across, round % 4), h);
    REQUIRE(frame.curves.count() == 8);
    const std::vector<double> steps = steps_of(frame, h);
    const auto middle = [&](Index c) {
      const auto ends = frame.curves.vertices.row(c);
      return 0.5 * (frame.mesh.points[ends.front()] + frame.mesh.points[ends.back()]);
    };
    for (Index a = 0; a < 8; ++a)
      for (Index b = 0; b < 8; ++b) {
        if (!(steps[a] > steps[b]) || distance(middle(a), middle(b)) > 1.001 * across) continue;
        const Index rows = across / h > 0.5 ? 1 : 0;
        CHECK(edge_count(frame, a) - edge_count(frame, b) == 2 * rows);
        with_other_wishes += std::round(steps[a]) - std::round(steps[b]) != 2.0 * rows;
      }
  }
  CHECK(with_other_wishes > 20);
}

TEST_CASE("a small triangular face gets more than one quad") {
  SurfaceSoup soup;
  soup.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (const double h : {1.2, 1.6, 2.2}) {
    const auto all = curves_of(soup, h);
    REQUIRE(all.curves.count() == 6);
    for (Index c = 0; c < 6; ++c) CHECK(edge_count(all, c) >= 2);
  }
}

TEST_CASE("bends smaller than the mesh are corners, round lines are not") {
  for (const double r : {0.1, 0.3, 0.5}) {
    const auto plate = curves_of(rounded_plate(3, r), 1);
    REQUIRE(plate.curves.count() == 4);
    for (Index v = 0; v < plate.mesh.vertex_count(); ++v) {
      if (!plate.features.corner[v]) continue;  // in the middle of its quarter
      const Vec3 p = plate.mesh.points[v];
      CHECK(std::abs(p.x) == Approx(std::abs(p.y)));
    }
  }
  for (const double h : {0.01, 0.2, 0.5, 0.9, 2.0}) {
    CHECK(curves_of(rounded_plate(1e-9, 1), h).curves.count() == 1);  // a disk
  }
  CHECK(curves_of(rounded_plate(3, 2), 1).curves.count() == 1);  // what the mesh can follow
}

TEST_CASE("wide bends count as turns where a border turns by right angles in all") {
  // Half a disk: beside the mesh its arc is straight.
  SurfaceSoup half;
  half.points.push_back({});
  for (int k = 0; k <= 48; ++k)
    half.points.push_back({5 * std::cos(pi * k / 48), 5 * std::sin(pi * k / 48), 0});
  for (Index k = 1; k <= 48; ++k) half.triangles.push_back({0, k, k + 1});
  const Curves disk = curves_of(half, 1);
  const auto borders = borders_of(disk, 1);
  REQUIRE(borders.size() == 1);
  CHECK(borders[0].turns == 4);
  const auto arc = std::find_if(borders[0].sides.begin(), borders[0].sides.end(),
                                [](const BorderSide& side) { return !side.is_straight(); });
  REQUIRE(arc != borders[0].sides.end());
  CHECK(arc->whole() == Approx(5 * pi).epsilon(0.01));
  std::array<double, 4> length = arc->length;  // a quarter up, a half along, a quarter down
  std::sort(length.begin(), length.end());
  CHECK(length[0] == 0);
  CHECK(length[1] == Approx(1.25 * pi).epsilon(0.1));
  CHECK(length[3] == Approx(2.5 * pi).epsilon(0.1));

  // Six corners of 60 degrees: which two of them do not count, nothing says.
  SurfaceSoup hexagon;
  hexagon.points.push_back({});
  constexpr Index around = 30;
  for (Index k = 0; k < around; ++k) {
    const double a = pi / 3 * (k / 5), b = a + pi / 3, t = (k % 5) / 5.0;
    hexagon.points.push_back({5 * ((1 - t) * std::cos(a) + t * std::cos(b)),
                              5 * ((1 - t) * std::sin(a) + t * std::sin(b)), 0});
  }
  for (Index k = 0; k < around; ++k) hexagon.triangles.push_back({0, 1 + k, 1 + (k + 1) % around});
  const Curves six = curves_of(hexagon, 1);
  CHECK(borders_of(six, 1).at(0).turns == 6);
}

TEST_CASE("every hole gets an even number of edges") {
  // Two triangles are missing in a lattice of them.
  SurfaceSoup soup;
  constexpr Index width = 7, height = 5;
  for (Index y = 0; y < height; ++y)
    for (Index x = 0; x < width; ++x) soup.points.push_back({x + 0.5 * y, std::sqrt(0.75) * y, 0});
  for (Index y = 0; y + 1 < height; ++y)
    for (Index x = 0; x + 1 < width; ++x) {
      const Index a = y * width + x;
      if (!(y == 1 && (x == 1 || x == 4))) soup.triangles.push_back({a, a + 1, a + width});
      soup.triangles.push_back({a + 1, a + width + 1, a + width});
    }
  for (const double h : {0.2, 0.3, 0.35, 0.5}) {
    const Curves all = curves_of(soup, h);
    Index holes = 0;
    for (const FaceBorder& border : borders_of(all, h)) {
      if (border.sides.size() != 3) continue;
      ++holes;
      Index edges = 0;
      for (const BorderSide& side : border.sides) edges += edge_count(all, side.curve);
      CHECK(edges % 2 == 0);
    }
    CHECK(holes == 2);
  }
}

TEST_CASE("counts go back to what the sizes ask for where sums let them") {
  // A side of 7.5 steps opposite two of 3.7 and 5.3, and the same behind the latter: all balanced,
  // but far from their steps.
  CountSums sums;
  for (const auto& row : {std::array<CountTerm, 3>{{{0, 1}, {1, -1}, {2, -1}}},
                          std::array<CountTerm, 3>{{{2, 1}, {3, 1}, {4, -1}}}}) {
    sums.terms.values.insert(sums.terms.values.end(), row.begin(), row.end());
    sums.terms.end_row();
  }
  sums.constant = {0, 0};
  sums.only_parity = sums.across_ring = sums.between_circles = {0, 0};
  const std::vector<CountWish> wishes{{7.5}, {3.7}, {5.3}, {3.7}, {7.5}};
  std::vector<Index> counts{6, 4, 2, 4, 6};
  const auto misfit = [&](const std::vector<Index>& n) {
    double sum = 0;
    for (std::size_t c = 0; c < n.size(); ++c) {
      const double off = n[c] - wishes[c].steps;
      sum += off * off / wishes[c].steps;
    }
    return sum;
  };
  balance_counts(sums, wishes, counts);
  CHECK(counts[0] == counts[1] + counts[2]);
  CHECK(counts[4] == counts[2] + counts[3]);
  double least = 1e9;
  for (Index a = 1; a < 12; ++a)
    for (Index b = 1; b < 12; ++b)
      for (Index c = 1; c < 12; ++c) least = std::min(least, misfit({a + b, a, b, c, b + c}));
  CHECK(misfit(counts) == Approx(least));
}

TEST_CASE("a dangling line and a cut have the same face on both sides") {
  const auto band = curves_of(band_soup(12, 1), 0.2, {.angle = 180});
  bool found = false;
  for (Index c = 0; c < band.curves.count(); ++c) {
    const auto faces = band.curves.faces.row(c);
    found = found || (faces.size() == 2 && faces[0] == faces[1]);
  }
  CHECK(found);
}

TEST_CASE("random patchworks of groups: every face can be all quads at every size") {
  Rng rng(7);
  for (int round = 0; round < 60; ++round) {
    const int n = 6;
    SurfaceSoup soup =
        round % 2 == 0 ? sheet_soup(n, [](int, int) { return 0; }) : box_soup({6, 6, 6}, n);
    const Index groups = 2 + static_cast<Index>(rng.below(12));
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
      soup.group.push_back(static_cast<Index>(rng.below(static_cast<std::uint64_t>(groups))));
    soup.group_names.assign(static_cast<std::size_t>(groups), "x");
    curves_of(soup, rng.between(0.2, 4));
  }
}

TEST_CASE("sheets meeting in threes: every face is even") {
  Rng rng(9);
  for (int round = 0; round < 40; ++round) {
    SurfaceSoup soup;
    for (int sheet = 0; sheet < 4; ++sheet) {
      const SurfaceSoup one = sheet_soup(4, [](int, int) { return 0; });
      const auto first = static_cast<Index>(soup.points.size());
      for (const Vec3 p : one.points) {
        const Vec3 turned[] = {{p.x, p.y, 2}, {p.x, 2, p.y}, {2, p.x, p.y}, {p.x, p.y, 4}};
        soup.points.push_back(turned[sheet]);
      }
      for (const Tri& t : one.triangles) {
        soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        soup.group.push_back(rng.below(6) == 0);
      }
    }
    soup.group_names = {"a", "b"};
    curves_of(soup, rng.between(0.3, 3));
  }
}

TEST_CASE("two curves with the same ends do not become the same edge") {
  // A lens: two faces side by side in a square, meeting in two points of the border.
  SurfaceSoup soup = sheet_soup(2, [](int, int) { return 0; });
  soup.group = {0, 1, 1, 2, 1, 2, 2, 2};
  soup.group_names = {"a", "b", "c"};
  curves_of(soup, 50);
}

TEST_CASE("sizes that cannot be are refused") {
  const auto box = curves_of(box_soup({1, 1, 1}, 1), 0.1);
  for (const double size : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    std::vector<double> sizes = box.size;
    sizes[3] = size;
    const auto nodes = mesh_curves(box.mesh, box.features, box.curves, sizes);
    REQUIRE_FALSE(nodes.has_value());
    CHECK(nodes.error().code == ErrorCode::bad_size);
  }
  const std::vector<double> tiny(box.size.size(), 1e-12);
  const auto nodes = mesh_curves(box.mesh, box.features, box.curves, tiny);
  REQUIRE_FALSE(nodes.has_value());
  CHECK(nodes.error().code == ErrorCode::too_many_elements);
}

// Features, corners and faces of surfaces whose lines are known.
#include "surface/features.h"

#include "base/rng.h"
#include "catch.h"
#include "support/surface_checks.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"
#include "surface/bends.h"
#include "surface/needles.h"
#include "surface/normals.h"
#include "surface/repair.h"
#include "surface/sharp_edges.h"

using namespace lpq;
using namespace lpq_test;

namespace {

SurfaceMesh mesh_of(const SurfaceSoup& soup) {
  auto surface = repair_surface(soup);
  REQUIRE(surface.has_value());
  return std::move(surface->mesh);
}

SurfaceFeatures features_of(const SurfaceMesh& mesh, double size = 1, FeatureOptions options = {}) {
  return find_features(mesh, std::vector<double>(mesh.points.size(), size), options);
}

Index count_of(const SurfaceFeatures& features, FeatureKind kind) {
  return static_cast<Index>(std::count(features.kind.begin(), features.kind.end(), kind));
}
Index corners_of(const SurfaceFeatures& features) {
  return static_cast<Index>(std::count(features.corner.begin(), features.corner.end(), 1));
}

/// A sheet of n x n squares, folded along x = n / 2 by a height of slope(j) on both sides.
SurfaceSoup ridge(int n, const std::vector<double>& slope) {
  return sheet_soup(n, [&](int i, int j) { return -slope[j] * std::abs(i - n / 2); });
}

/// Every vertex thrown about by up to `most` in each direction.
SurfaceMesh noisy(SurfaceMesh mesh, double most) {
  Rng rng(11);
  for (Vec3& p : mesh.points)
    p += {rng.between(-most, most), rng.between(-most, most), rng.between(-most, most)};
  return mesh;
}

Index sharp_edges_of(const SurfaceMesh& mesh) {
  const auto angles = edge_angles(mesh, std::vector<double>(mesh.points.size(), 1),
                                  surface_edges(mesh.triangles, mesh.vertex_count()));
  return static_cast<Index>(
      std::count_if(angles.begin(), angles.end(), [](double angle) { return angle > 40; }));
}

/// `count` of them up to `most` up or down.
std::vector<double> bumps_of(std::size_t count, double most, int seed) {
  Rng rng(seed);
  std::vector<double> bumps(count);
  for (double& z : bumps) z = rng.between(-most, most);
  return bumps;
}

/// Sharp edges on a line x = const.
Index sharp_along(const SurfaceMesh& mesh, const SurfaceFeatures& features, double x) {
  Index count = 0;
  for (Index i = 0; i < features.edges.count(); ++i) {
    const auto& [a, b] = features.edges.ends[i];
    const bool along = mesh.points[a].x == x && mesh.points[b].x == x;
    count += along && features.kind[i] == FeatureKind::sharp;
  }
  return count;
}

}  // namespace

TEST_CASE("facets far finer than the mesh are no needles: a cylinder of them keeps its rims") {
  // 8000 facets of 0.0008 beside a size of 0.5; the caps are fans.
  const int n = 8000;
  SurfaceSoup soup;
  soup.points = {{0, 0, 0}, {0, 0, 10}};
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    for (const double z : {0.0, 10.0}) soup.points.push_back({std::cos(angle), std::sin(angle), z});
    const Index a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);
    soup.triangles.push_back({a, b, b + 1});
    soup.triangles.push_back({a, b + 1, a + 1});
    soup.triangles.push_back({0, b, a});
    soup.triangles.push_back({1, a + 1, b + 1});
  }
  const SurfaceFeatures features = features_of(mesh_of(soup), 0.5);
  CHECK(features.face_count == 3);
  CHECK(count_of(features, FeatureKind::sharp) == 2 * n);
}

TEST_CASE("a box has twelve sides, eight corners and six faces") {
  const SurfaceMesh mesh = mesh_of(box_soup({1, 2, 3}, 5));
  const auto box = features_of(mesh, 0.2);
  CHECK(count_of(box, FeatureKind::sharp) == 60);
  CHECK(corners_of(box) == 8);
  CHECK(box.face_count == 6);
  CHECK(features_of(mesh, 0.2, {.angle = 89}).face_count == 6);
  const auto smooth = features_of(mesh, 0.2, {.angle = 91});
  CHECK(smooth.face_count == 1);
  CHECK(corners_of(smooth) == 0);
}

TEST_CASE("every edge of a flat sheet is smooth, its border is kept") {
  const SurfaceMesh mesh = mesh_of(sheet_soup(6, [](int, int) { return 0; }));
  const auto sheet = features_of(mesh);
  CHECK(count_of(sheet, FeatureKind::wall) == 24);
  CHECK(count_of(sheet, FeatureKind::smooth) == sheet.edges.count() - 24);
  CHECK(corners_of(sheet) == 4);
  CHECK(features_of(mesh, 100).face_count == 1);
}

TEST_CASE("a chain goes on while it is less sharp, and ends where it is smooth") {
  // Angles between normals: 2 atan(slope).
  const auto fold = [](std::vector<double> slope) {
    const SurfaceMesh mesh = mesh_of(ridge(8, slope));
    return count_of(features_of(mesh, 0.5), FeatureKind::sharp);
  };
  CHECK(fold(std::vector<double>(9, 0.5)) == 8);  // 53 degrees
  CHECK(fold(std::vector<double>(9, 0.3)) == 0);  // 33 degrees: nothing starts it
  CHECK(fold({0.5, 0.5, 0.5, 0.5, 0.3, 0.3, 0.3, 0.3, 0.3}) == 8);
  const Index fading = fold({0.5, 0.5, 0.45, 0.38, 0.3, 0.24, 0.2, 0.15, 0.1});
  CHECK(fading >= 5);
  CHECK(fading < 8);
}

TEST_CASE("a chain goes on only while it stands out from the surface beside it") {
  constexpr int n = 20;
  const std::vector<double> bumps = bumps_of((n + 1) * (n + 1), 1, 3);
  const auto sharp_with = [&](double height) {
    // Sharp in one half; in the other weak, and uneven beside it.
    const SurfaceMesh mesh = mesh_of(sheet_soup(n, [&](int i, int j) {
      const bool second = j > n / 2, beside = i != n / 2;
      return (second && beside ? height * bumps[(n + 1) * i + j] : 0) -
             (second ? 0.3 : 0.5) * std::min(std::abs(i - n / 2), 2);
    }));
    return count_of(features_of(mesh), FeatureKind::sharp);
  };
  CHECK(sharp_with(0) == n);
  const Index uneven = sharp_with(0.2);
  CHECK(uneven >= n / 2 - 1);
  CHECK(uneven < 3 * n / 4);
}

TEST_CASE("small bumps are noise, unless they touch something hard") {
  const auto bump = [](int at) {
    return mesh_of(sheet_soup(20, [at](int i, int j) { return i == at && j == 10 ? 1.0 : 0.0; }));
  };
  CHECK(count_of(features_of(bump(10), 3), FeatureKind::sharp) == 0);
  CHECK(features_of(bump(10), 3).face_count == 1);
  CHECK(count_of(features_of(bump(10), 0.4), FeatureKind::sharp) > 0);
  CHECK(count_of(features_of(bump(1), 1), FeatureKind::sharp) > 0);
}

TEST_CASE("rims of holes are kept at every size, small loops of noise are not") {
  // A plate with a round pit of so many sides; the points of its rim go up and down.
  const auto pit = [](int sides, double uneven, double width = 30) {
    SurfaceSoup soup;
    const std::vector<double> bumps = bumps_of(sides, 1, 3);
    const auto ring = [&](double r, double z) {
      for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265358979 * i / sides;
        soup.points.push_back({r * std::cos(angle), r * std::sin(angle), z + uneven * bumps[i]});
      }
    };
    ring(width, 0);
    ring(1, 0);
    ring(1, -2);
    soup.points.push_back({0, 0, -2});
    const Index n = sides;
    for (Index i = 0; i < n; ++i) {
      const Index j = (i + 1) % n;
      for (Index row = 0; row < 2; ++row) {
        soup.triangles.push_back({row * n + i, row * n + j, (row + 1) * n + j});
        soup.triangles.push_back({row * n + i, (row + 1) * n + j, (row + 1) * n + i});
      }
      soup.triangles.push_back({2 * n + i, 2 * n + j, 3 * n});
    }
    return mesh_of(soup);
  };
  CHECK(features_of(pit(16, 0), 10).face_count == 3);
  CHECK(features_of(pit(4, 0), 10).face_count == 1 + 4 + 1);
  CHECK(features_of(pit(5, 0), 10).face_count == 1 + 5 + 1);
  CHECK(features_of(pit(5, 0.5, 6), 10).face_count == 1);
}

TEST_CASE("rims of holes with coarse facets are kept whole at every size and angle") {
  // A plate with a blind hole; the points of its wall are anywhere on the round, between the rims.
  const auto blind = [](int sides, double depth, int seed) {
    constexpr int rows = 5;  // plate, upper rim, wall, wall, lower rim
    const std::vector<double> turns = bumps_of(rows * sides, 0.35, seed);
    const std::vector<double> bumps = bumps_of(rows * sides, 0.1 * depth, seed + 1);
    SurfaceSoup soup;
    for (int row = 0; row < rows; ++row)
      for (int i = 0; i < sides; ++i) {
        const bool wall = row == 2 || row == 3;
        const int k = row * sides + i;
        const double angle = 2 * 3.14159265358979 * (i + (wall ? turns[k] : 0)) / sides;
        const double r = row == 0 ? 20 : 3, z = depth * std::max(row - 1, 0) / 3;
        soup.points.push_back(
            {r * std::cos(angle), r * std::sin(angle), -z + (wall ? bumps[k] : 0)});
      }
    for (Index i = 0; i < sides; ++i)
      for (Index row = 0; row + 1 < rows; ++row) {
        const Index j = (i + 1) % sides, a = row * sides, b = a + sides;
        soup.triangles.push_back({a + i, a + j, b + j});
        soup.triangles.push_back({a + i, b + j, b + i});
      }
    const Index bottom = (rows - 1) * sides;
    for (Index i = 1; i + 1 < sides; ++i)
      soup.triangles.push_back({bottom, bottom + i, bottom + i + 1});
    return mesh_of(soup);
  };
  for (const int sides : {6, 8, 9, 12})
    for (const double depth : {6.0, 15.0})
      for (const int seed : {3, 4, 5}) {
        const SurfaceMesh mesh = blind(sides, depth, seed);
        for (const double size : {2.0, 3.5, 4.66, 6.0, 9.0, 15.0})
          for (const double angle : {30.0, 40.0, 50.0, 60.0}) {
            const SurfaceFeatures features = features_of(mesh, size, {.angle = angle});
            Index rims = 0;
            for (Index i = 0; i < features.edges.count(); ++i) {
              const auto& [a, b] = features.edges.ends[i];
              const bool upper = a >= sides && b < 2 * sides, lower = a >= 4 * sides;
              rims += features.kind[i] == FeatureKind::sharp &&
                      mesh.points[a].z == mesh.points[b].z && (upper || lower);
            }
            INFO(sides << " sides, " << depth << " deep, seed " << seed << ", size " << size
                       << ", angle " << angle);
            CHECK(rims == 2 * sides);
          }
      }
}

TEST_CASE("borders between groups are kept, unless the caller says otherwise") {
  SurfaceSoup soup = sheet_soup(6, [](int, int) { return 0; });
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    soup.group.push_back(t < soup.triangles.size() / 2 ? 0 : 1);
  soup.group_names = {"a", "b"};
  const SurfaceMesh mesh = mesh_of(soup);
  const auto two = features_of(mesh, 10);
  CHECK(two.face_count == 2);
  CHECK(count_of(two, FeatureKind::group_border) == 6);
  CHECK(corners_of(two) == 6);
  CHECK(features_of(mesh, 10, {.groups = false}).face_count == 1);
  CHECK(count_of(two, FeatureKind::wall) == 24);
}

TEST_CASE("jagged borders have no corner at every tooth") {
  SurfaceSoup soup = sheet_soup(20, [](int, int) { return 0; });
  for (int i = 1; i < 20; i += 2) soup.points[i].y -= 0.9;
  const SurfaceMesh mesh = mesh_of(soup);
  CHECK(corners_of(features_of(mesh, 8)) <= 6);
  CHECK(corners_of(features_of(mesh, 0.1)) >= 20);
}

TEST_CASE("sheets that meet: walls are features, points where only cones meet are corners") {
  SurfaceSoup soup = sheet_soup(4, [](int, int) { return 0; });
  const SurfaceSoup other = sheet_soup(4, [](int, int) { return 0; });
  const auto first = static_cast<Index>(soup.points.size());
  for (const Vec3 p : other.points) soup.points.push_back({p.x, 2, p.y});
  for (const Tri& t : other.triangles)
    soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const SurfaceMesh mesh = mesh_of(soup);
  const auto joint = features_of(mesh, 10);
  CHECK(joint.face_count == 3);
  CHECK(corners_of(joint) == 4 + 2 + 2);

  const SurfaceMesh cones = mesh_of([] {
    SurfaceSoup two;
    for (const double z : {1.0, -1.0}) {
      const auto at = static_cast<Index>(two.points.size());
      for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1, 0, z}, Vec3{0, 1, z}, Vec3{-1, -1, z}})
        two.points.push_back(p);
      for (Index k = 1; k <= 3; ++k) two.triangles.push_back({at, at + k, at + k % 3 + 1});
    }
    return two;
  }());
  const auto pair = features_of(cones, 10, {.angle = 180});
  CHECK(pair.corner[0] == 1);
}

TEST_CASE("needles lower than anything the mesh shows make no face of their own") {
  // A vertex pulled over the border of a sheet by 1/500: a needle there looks down.
  SurfaceSoup soup = sheet_soup(4, [](int, int) { return 0; });
  const auto apex = static_cast<Index>(soup.points.size());
  soup.points.push_back({1.5, -2e-3, 1e-3});
  std::erase_if(soup.triangles, [](const Tri& t) { return t == Tri{1, 2, 7}; });
  for (const Tri& t : {Tri{1, 2, apex}, Tri{2, 7, apex}, Tri{7, 1, apex}})
    soup.triangles.push_back(t);
  const SurfaceMesh mesh = mesh_of(soup);
  CHECK(count_of(features_of(mesh, 2), FeatureKind::sharp) == 0);
  for (const Vec3 n : triangle_normals(mesh, std::vector<double>(mesh.points.size(), 2)))
    CHECK(n.z > 0.9);
  CHECK(count_of(features_of(mesh, 0.01), FeatureKind::sharp) > 0);  // a fine mesh shows it
}

TEST_CASE("features that fold back along a needle become one line, on uneven surfaces") {
  // The diagonal a-b of a square, and a vertex beside it.
  SurfaceSoup soup = sheet_soup(4, [](int, int) { return 0; });
  const auto apex = static_cast<Index>(soup.points.size());
  soup.points.push_back({1.7, 1.72, 0});
  const Index a = 6, b = 12;
  std::erase_if(soup.triangles, [&](const Tri& t) { return t == Tri{a, b, b - 1}; });
  for (const Tri& t : {Tri{a, apex, b - 1}, Tri{apex, b, b - 1}, Tri{a, b, apex}})
    soup.triangles.push_back(t);
  const SurfaceMesh mesh = mesh_of(soup);
  const auto sharp_after = [&](double size, double beside, FeatureKind kind) {
    SurfaceFeatures features;
    features.edges = surface_edges(mesh.triangles, mesh.vertex_count());
    features.kind.assign(features.edges.ends.size(), FeatureKind::smooth);
    std::vector<double> angles(features.edges.ends.size(), beside);
    const auto edge = [&](Index v, Index w) {
      const std::array<Index, 2> ends{v, w};
      return static_cast<Index>(
          std::find(features.edges.ends.begin(), features.edges.ends.end(), ends) -
          features.edges.ends.begin());
    };
    for (const Index fold : {edge(a, b), edge(a, apex)}) {
      features.kind[fold] = kind;
      angles[fold] = 50;
    }
    unfold_needles(mesh, std::vector<double>(mesh.points.size(), size), angles, {}, features);
    return std::array<bool, 3>{features.is_feature(edge(a, b)), features.is_feature(edge(a, apex)),
                               features.is_feature(edge(b, apex))};
  };
  const std::array<bool, 3> folded{true, true, false}, unfolded{false, true, true};
  CHECK(sharp_after(1, 20, FeatureKind::sharp) == unfolded);
  CHECK(sharp_after(0.1, 20, FeatureKind::sharp) == folded);  // a fine mesh shows it
  CHECK(sharp_after(1, 2, FeatureKind::sharp) == folded);     // it stands out
  CHECK(sharp_after(1, 20, FeatureKind::marked) == folded);
}

TEST_CASE("a needle with three sharp sides is no face of its own") {
  // A vertex inside a flat sheet, or on the ridge of a roof, pushed across the edge beside it.
  for (const double slope : {0.0, 1.0}) {
    SurfaceSoup soup = sheet_soup(6, [slope](int i, int) { return -slope * std::abs(i - 3); });
    const Index a = 2 * 7 + 3, b = a + 7, c = a + 1, d = b + 1;  // a square right of the ridge
    std::erase_if(soup.triangles, [&](const Tri& t) {
      return std::all_of(t.begin(), t.end(),
                         [&](Index v) { return v == a || v == b || v == c || v == d; });
    });
    const Vec3 m = 0.55 * soup.points[a] + 0.45 * soup.points[b];
    const auto apex = static_cast<Index>(soup.points.size());
    const Vec3 right = soup.points[c] - soup.points[a];
    soup.points.push_back(m - 0.01 * right);
    soup.triangles.insert(soup.triangles.end(),
                          {{a, c, apex}, {c, d, apex}, {d, b, apex}, {b, a, apex}});
    const SurfaceMesh mesh = mesh_of(soup);
    const SurfaceFeatures features = features_of(mesh, 0.5);
    CHECK(features.face_count == (slope == 0 ? 1 : 2));
  }
}

TEST_CASE("needles in a plane do not make it sharp") {
  // A plane with a vertex so near an edge that rounding decides where the triangle looks.
  SurfaceSoup soup = sheet_soup(4, [](int, int) { return 0; });
  const auto apex = static_cast<Index>(soup.points.size());
  soup.points.push_back({1.5, 1.5 + 1e-8, 1e-7});
  const Index a = 6, b = 12;  // the diagonal of square (1, 1)
  std::erase_if(soup.triangles, [&](const Tri& t) { return t == Tri{a, b, b - 1}; });
  soup.triangles.push_back({a, apex, b - 1});
  soup.triangles.push_back({apex, b, b - 1});
  soup.triangles.push_back({a, b, apex});
  const SurfaceMesh mesh = mesh_of(soup);
  for (const Vec3 n : triangle_normals(mesh)) CHECK(n.z > 0.99);
  CHECK(count_of(features_of(mesh, 0.1), FeatureKind::sharp) == 0);
}

TEST_CASE("sharp edges that noise leaves on round surfaces are no features") {
  const SurfaceMesh ball = noisy(sphere(12), 0.02), ring = noisy(torus(96, 48, 1, 0.4), 0.01);
  for (const SurfaceMesh* mesh : {&ball, &ring}) {
    CHECK(sharp_edges_of(*mesh) > 20);
    const auto features = features_of(*mesh, 0.15);
    CHECK(count_of(features, FeatureKind::sharp) == 0);
    CHECK(features.face_count == 1);
  }
}

TEST_CASE("noise takes no edge from a box, however large the mesh") {
  const SurfaceMesh box = noisy(mesh_of(box_soup({1, 1, 1}, 6)), 0.004);
  for (const double size : {0.1, 0.3, 0.5}) {
    const auto features = features_of(box, size);
    CHECK(count_of(features, FeatureKind::sharp) == 72);
    CHECK(features.face_count == 6);
  }
}

TEST_CASE("of a rough chain between side branches only long pieces are kept") {
  constexpr int n = 40;
  const std::vector<double> bumps = bumps_of((n + 1) * (n + 1), 0.14, 5);
  // A spike beside the crease at every `gap` has sharp edges that end at it.
  const auto on_crease = [&](int gap) {
    const SurfaceMesh mesh = mesh_of(sheet_soup(n, [&](int i, int j) {
      const bool spike = i == n / 2 + 1 && j % gap == gap / 2;
      return bumps[(n + 1) * i + j] - 0.6 * std::abs(i - n / 2) + (spike ? 1.2 : 0);
    }));
    return sharp_along(mesh, features_of(mesh), n / 2);
  };
  CHECK(on_crease(10) >= 30);
  CHECK(on_crease(4) <= 15);
}

TEST_CASE("a crease on an uneven surface is kept whole if it is long for the mesh size") {
  const std::vector<double> bumps = bumps_of(21 * 21, 0.14, 5);
  const SurfaceMesh mesh = mesh_of(
      sheet_soup(20, [&](int i, int j) { return bumps[21 * i + j] - 0.6 * std::abs(i - 10); }));
  CHECK(sharp_edges_of(mesh) >= 20);
  const auto fine = features_of(mesh, 2);
  CHECK(sharp_along(mesh, fine, 10) == 20);
  CHECK(count_of(fine, FeatureKind::sharp) == 20);
  CHECK(count_of(features_of(mesh, 2, {.angle = 180}), FeatureKind::sharp) == 0);
}

TEST_CASE("of many bends along a closed line no two are nearer than most of a mesh size") {
  constexpr int n = 3000;
  constexpr double h = 0.05;
  SurfaceSoup wheel;
  for (int i = 0; i < n; ++i) {
    const double r = 1 + 0.02 * std::cos(turn * 60 * i / n) + 0.01 * std::cos(turn * 97 * i / n);
    wheel.points.push_back({r * std::cos(turn * i / n), r * std::sin(turn * i / n), 0});
    wheel.triangles.push_back({i, (i + 1) % n, n});
  }
  wheel.points.push_back({0, 0, 0});
  const SurfaceMesh mesh = mesh_of(wheel);
  SurfaceFeatures features = features_of(mesh, h);
  features.corner.assign(mesh.points.size(), 0);
  mark_bends(mesh, std::vector<double>(mesh.points.size(), h), 30, features);
  std::vector<double> at;
  double s = 0;
  for (Index v = 0; v < n; ++v) {  // the border, in this order
    if (features.corner[v]) at.push_back(s);
    s += distance(mesh.points[v], mesh.points[(v + 1) % n]);
  }
  REQUIRE(at.size() > 20);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double next = k + 1 < at.size() ? at[k + 1] : s + at[0];
    CHECK(next - at[k] > 0.75 * h * (1 - 1e-9));
  }
}

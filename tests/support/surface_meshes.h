// Surfaces whose curvature, topology and maps are known.
#pragma once

#include <cmath>
#include <vector>

#include "mesh/surface_mesh.h"
#include "support/shared_surfaces.h"
#include "surface/soup.h"

namespace lpq_test {

constexpr double turn = 6.283185307179586;

/// The triangles as a reader gives them, in one group without a name.
inline lpq::SurfaceSoup soup_of(const lpq::SurfaceMesh& mesh) {
  lpq::SurfaceSoup soup;
  soup.points = mesh.points;
  soup.triangles = mesh.triangles;
  soup.group_names = {""};
  return soup;
}

/// A grid of n x m squares, each two triangles, at place(u, v) for u, v in 0 .. 1; triangles look
/// along d/du x d/dv. Periodic shapes close by their points being equal.
template <class Place>
lpq::SurfaceMesh grid_surface(int n, int m, Place place, bool round_u = false,
                              bool round_v = false) {
  std::vector<lpq::Vec3> points;
  std::vector<lpq::Tri> triangles;
  const auto at = [&](int i, int j) {
    return static_cast<lpq::Index>((round_v ? j % m : j) * (n + 1) + (round_u ? i % n : i));
  };
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i)
      points.push_back(place(static_cast<double>(i) / n, static_cast<double>(j) / m));
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const lpq::Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if ((i + j) % 2) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  return SurfaceBuilder().build(std::move(points), triangles);
}

inline lpq::SurfaceMesh plane_square(int n) {
  return grid_surface(n, n, [](double u, double v) { return lpq::Vec3{u, v, 0}; });
}

inline lpq::SurfaceMesh cylinder(int n, int m, double radius, double height) {
  return grid_surface(
      n, m,
      [=](double u, double v) {
        return lpq::Vec3{radius * std::cos(turn * u), radius * std::sin(turn * u), height * v};
      },
      true);
}

/// The part of a cone round the z axis between two distances from its apex; `share` is the opening
/// angle of the unrolled cone as a share of a full turn (the sine of the half angle).
inline lpq::SurfaceMesh cone(int n, int m, double from, double to, double share) {
  return grid_surface(
      n, m,
      [=](double u, double v) {
        const double s = from + (to - from) * v;
        return lpq::Vec3{s * share * std::cos(turn * u), s * share * std::sin(turn * u),
                         -s * std::sqrt(1 - share * share)};
      },
      true);
}

inline lpq::SurfaceMesh torus(int n, int m, double large, double small) {
  return grid_surface(
      n, m,
      [=](double u, double v) {
        const double r = large + small * std::cos(turn * v);
        return lpq::Vec3{r * std::cos(turn * u), r * std::sin(turn * u),
                         small * std::sin(turn * v)};
      },
      true, true);
}

/// The surface of the cube [-1, 1]^3, n x n squares a side, each point moved by `place`.
template <class Place>
lpq::SurfaceMesh cube_surface(int n, Place place) {
  std::vector<lpq::Vec3> points;
  std::vector<lpq::Tri> triangles;
  for (int side = 0; side < 6; ++side) {
    const lpq::Index first = static_cast<lpq::Index>(points.size());
    const double sign = side % 2 ? -1 : 1;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double u = sign * (2 * i - n) / n, v = (2.0 * j - n) / n;
        points.push_back(place(side / 2 == 0   ? lpq::Vec3{sign, u, v}
                               : side / 2 == 1 ? lpq::Vec3{v, sign, u}
                                               : lpq::Vec3{u, v, sign}));
      }
    for (lpq::Index j = 0; j < n; ++j)
      for (lpq::Index i = 0; i < n; ++i) {
        const lpq::Index a = first + j * (n + 1) + i;
        triangles.push_back({a, a + 1, a + n + 2});
        triangles.push_back({a, a + n + 2, a + n + 1});
      }
  }
  return SurfaceBuilder().build(std::move(points), triangles);
}

inline lpq::SurfaceMesh cube(int n) {
  return cube_surface(n, [](lpq::Vec3 p) { return p; });
}

inline lpq::SurfaceMesh sphere(int n) {
  return cube_surface(n, [](lpq::Vec3 p) { return (1 / length(p)) * p; });
}

/// The cap of the unit sphere down to polar angle `opening`: m rings round the pole, 6 j points in
/// ring j.
inline lpq::SurfaceMesh sphere_cap(int m, double opening) {
  std::vector<lpq::Vec3> points{{0, 0, 1}};
  std::vector<lpq::Tri> triangles;
  const auto at = [](int j, int i) {
    return static_cast<lpq::Index>(j == 0 ? 0 : 3 * j * (j - 1) + 1 + i % (6 * j));
  };
  for (int j = 1; j <= m; ++j) {
    const double polar = opening * j / m;
    for (int i = 0; i < 6 * j; ++i) {
      const double a = turn * i / (6 * j);
      points.push_back(
          {std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar)});
    }
    for (int side = 0; side < 6; ++side)
      for (int i = 0; i < j; ++i) {
        const int out = side * j + i, in = side * (j - 1) + i;
        triangles.push_back({at(j - 1, in), at(j, out), at(j, out + 1)});
        if (i + 1 < j) triangles.push_back({at(j - 1, in), at(j, out + 1), at(j - 1, in + 1)});
      }
  }
  return SurfaceBuilder().build(std::move(points), triangles);
}

inline double surface_area(const lpq::SurfaceMesh& mesh) {
  double sum = 0;
  for (lpq::Index t = 0; t < mesh.triangle_count(); ++t) sum += lpq::layout_of(mesh, t).area;
  return sum;
}

/// chi = V - E + T, with vertices on no triangle left out.
inline int euler(const lpq::SurfaceMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  int edges = 0, vertices = 0;
  for (lpq::Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    edges += mesh.twins[e] == lpq::none || mesh.twins[e] > e;
    used[mesh.origin(e)] = 1;
  }
  for (const char u : used) vertices += u;
  return vertices - edges + mesh.triangle_count();
}

}  // namespace lpq_test

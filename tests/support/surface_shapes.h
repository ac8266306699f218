// Small surfaces for tests.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "surface/soup.h"

namespace lpq_test {

/// A box [0,x] x [0,y] x [0,z], its sides cut into n x n squares of two triangles each.
inline lpq::SurfaceSoup box_soup(lpq::Vec3 size, int n) {
  using lpq::Index;
  using lpq::Vec3;
  lpq::SurfaceSoup soup;
  const auto side = [&](Vec3 corner, Vec3 u, Vec3 v) {
    const auto first = static_cast<Index>(soup.points.size());
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        soup.points.push_back(corner + (double(i) / n) * u + (double(j) / n) * v);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Index a = first + j * (n + 1) + i;
        soup.triangles.push_back({a, a + 1, a + n + 2});
        soup.triangles.push_back({a, a + n + 2, a + n + 1});
      }
  };
  const Vec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z}, o;
  side(o, y, x);
  side(z, x, y);
  side(o, x, z);
  side(y, z, x);
  side(o, z, y);
  side(x, y, z);
  return soup;
}

/// All in one, each a body of its own.
inline lpq::SurfaceSoup as_bodies(const std::vector<lpq::SurfaceSoup>& parts) {
  lpq::SurfaceSoup all;
  all.group_names = {""};
  for (const lpq::SurfaceSoup& part : parts) {
    const auto first = static_cast<lpq::Index>(all.points.size());
    const auto body = static_cast<lpq::Index>(all.body_names.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const auto& [a, b, c] : part.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
      all.group.push_back(0);
      all.body.push_back(body);
    }
    all.body_names.push_back("body " + std::to_string(body + 1));
  }
  return all;
}

/// The boxes [0,1] x [0,1] x [0,1] and [1,3] x [0,1] x [0,1], which share a side.
inline lpq::SurfaceSoup touching_boxes(int n) {
  lpq::SurfaceSoup next = box_soup({2, 1, 1}, n);
  for (lpq::Vec3& p : next.points) p.x += 1;
  return as_bodies({box_soup({1, 1, 1}, n), next});
}

/// A strip of n squares around an axis, closed after `half_turns` half turns: 0 makes a ring, 1 a
/// Moebius band. Orientation as the squares come.
inline lpq::SurfaceSoup band_soup(int n, int half_turns) {
  using lpq::Index;
  lpq::SurfaceSoup soup;
  constexpr double pi = 3.14159265358979323846;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n, tilt = 0.5 * half_turns * angle;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(tilt);
      soup.points.push_back({r * std::cos(angle), r * std::sin(angle), side * std::sin(tilt)});
    }
  }
  for (Index i = 0; i < n; ++i) {
    const bool crossed = i == n - 1 && half_turns % 2 == 1;
    const Index a = 2 * i, b = a + 1, c = 2 * ((i + 1) % n);
    const Index next_a = crossed ? c + 1 : c, next_b = crossed ? c : c + 1;
    soup.triangles.push_back({a, next_a, b});
    soup.triangles.push_back({b, next_a, next_b});
  }
  return soup;
}

/// Height field over n x n squares of side 1: z(i, j).
template <class Height>
lpq::SurfaceSoup sheet_soup(int n, Height&& z) {
  using lpq::Index;
  lpq::SurfaceSoup soup;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) soup.points.push_back({double(i), double(j), double(z(i, j))});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      soup.triangles.push_back({a, a + 1, a + n + 2});
      soup.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  return soup;
}

}  // namespace lpq_test

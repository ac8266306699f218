// Small output meshes for writers: every feature of the format once, and awkward names.
#pragma once

#include <string>
#include <vector>

#include "mesh/output_mesh.h"

namespace lpq_test {

/// Two regions side by side, two quads and two triangles, a tagged inlet, a tagged corner, and
/// coordinates that need all 17 digits.
inline lpq::OutputMesh two_region_mesh() {
  lpq::OutputMesh mesh;
  mesh.points = {{0, 0},     {1.0 / 3, 0}, {0.7, 0},           {0, 0.1},           {1.0 / 3, 0.1},
                 {0.7, 0.1}, {0, 0.25},    {1.0 / 3, 1.0 / 7}, {0.7, 2e-1 + 1e-17}};
  mesh.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 6, lpq::none}, {4, 5, 7, lpq::none}};
  mesh.points.pop_back();
  mesh.region = {0, 1, 0, 1};
  mesh.regions = {"steel \"A36\" & <co>", "air"};
  mesh.tags = {"inlet", "probe", "wall"};
  mesh.edges = {{.a = 0, .b = 1, .left = 0, .region = 0, .loop = 0, .edge = 0},
                {.a = 1, .b = 2, .left = 1, .region = 1, .loop = 0, .edge = 0},
                {.a = 2, .b = 5, .left = 1, .tag = 2, .region = 1, .loop = 0, .edge = 1},
                {.a = 5, .b = 7, .left = 1, .tag = 2, .region = 1, .loop = 0, .edge = 2},
                {.a = 7, .b = 4, .left = 1, .region = 1, .loop = 0, .edge = 3},
                {.a = 4, .b = 6, .left = 0, .region = 0, .loop = 0, .edge = 2},
                {.a = 6, .b = 3, .left = 0, .tag = 0, .region = 0, .loop = 0, .edge = 3},
                {.a = 3, .b = 0, .left = 0, .tag = 0, .region = 0, .loop = 0, .edge = 4},
                {.a = 1, .b = 4, .left = 0, .right = 1, .region = 0, .loop = 0, .edge = 1}};
  mesh.tagged_points = {{6, 1}};
  mesh.fixed = 8;
  return mesh;
}

/// One region, n x n quads of the unit square, the outline as one loop.
inline lpq::OutputMesh grid_mesh(int n) {
  lpq::OutputMesh mesh;
  const auto at = [n](int i, int j) { return static_cast<lpq::Index>(j * (n + 1) + i); };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.points.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      mesh.region.push_back(0);
    }
  const auto add = [&](lpq::Index a, lpq::Index b) {
    const auto edge = static_cast<lpq::Index>(mesh.edges.size());
    mesh.edges.push_back({.a = a, .b = b, .left = 0, .region = 0, .loop = 0, .edge = edge});
  };
  for (int k = 0; k < n; ++k) add(at(k, 0), at(k + 1, 0));
  for (int k = 0; k < n; ++k) add(at(n, k), at(n, k + 1));
  for (int k = n; k > 0; --k) add(at(k, n), at(k - 1, n));
  for (int k = n; k > 0; --k) add(at(0, k), at(0, k - 1));
  mesh.regions = {""};
  return mesh;
}

/// Columns of three quads: the first and the last of one name.
inline lpq::OutputMesh thrice_named_mesh() {
  lpq::OutputMesh mesh = grid_mesh(3);
  for (std::size_t f = 0; f < mesh.region.size(); ++f)
    mesh.region[f] = static_cast<lpq::Index>(f % 3);
  mesh.regions = {"A", "B", "A"};
  return mesh;
}

}  // namespace lpq_test

// Small quad meshes built by hand for the tests of the clean-up: grids, perturbed grids, and a
// field that is constant over their box.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/rng.h"
#include "field/field.h"
#include "mesh/quad_mesh.h"

namespace lpq_test {

/// Quads (0..n) x (0..m) of size h, boundary vertices first (fixed), then the interior ones.
inline lpq::QuadMesh grid(lpq::Index n, lpq::Index m, double h = 1) {
  using lpq::Index;
  lpq::QuadMesh mesh;
  std::vector<Index> id((n + 1) * (m + 1), lpq::none);
  const auto border = [&](Index i, Index j) { return i == 0 || j == 0 || i == n || j == m; };
  for (const bool fixed : {true, false}) {
    for (Index j = 0; j <= m; ++j)
      for (Index i = 0; i <= n; ++i)
        if (border(i, j) == fixed) {
          id[j * (n + 1) + i] = static_cast<Index>(mesh.points.size());
          mesh.points.push_back({h * i, h * j});
        }
    if (fixed) mesh.fixed = static_cast<Index>(mesh.points.size());
  }
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.faces.push_back({id[a], id[a + 1], id[a + n + 2], id[a + n + 1]});
      mesh.region.push_back(0);
    }
  return mesh;
}

/// Moves every free vertex by up to `amount` in each coordinate.
inline lpq::QuadMesh shaken(lpq::QuadMesh mesh, double amount, std::uint64_t seed = 1) {
  lpq::Rng rng(seed);
  for (std::size_t v = mesh.fixed; v < mesh.points.size(); ++v)
    mesh.points[v] += {rng.between(-amount, amount), rng.between(-amount, amount)};
  return mesh;
}

/// One mesh from points, faces and the number of fixed points.
inline lpq::QuadMesh mesh_of(std::vector<lpq::Vec2> points, std::vector<lpq::Face> faces,
                             lpq::Index fixed) {
  lpq::QuadMesh mesh;
  mesh.region.assign(faces.size(), 0);
  mesh.points = std::move(points);
  mesh.faces = std::move(faces);
  mesh.fixed = fixed;
  return mesh;
}

/// Sum of the signed areas of the faces.
inline double area_of(const lpq::QuadMesh& mesh) {
  double sum = 0;
  for (const lpq::Face& face : mesh.faces)
    for (int k = 0, n = lpq::corner_count(face); k < n; ++k)
      sum += 0.5 * lpq::cross(mesh.points[face[k]], mesh.points[face[(k + 1) % n]]);
  return sum;
}

/// Directed edges without a partner, sorted: the boundary as the mesh has it.
inline std::vector<std::array<lpq::Index, 2>> border_of(const lpq::QuadMesh& mesh) {
  std::vector<std::array<lpq::Index, 2>> edges, result;
  for (const lpq::Face& face : mesh.faces)
    for (int k = 0, n = lpq::corner_count(face); k < n; ++k)
      edges.push_back({face[k], face[(k + 1) % n]});
  std::sort(edges.begin(), edges.end());
  for (const auto& e : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::array<lpq::Index, 2>{e[1], e[0]}))
      result.push_back(e);
  return result;
}

/// A grid in which random neighbouring pairs of quads had their common edge turned: many defects of
/// valence, many bad shapes, the same boundary.
inline lpq::QuadMesh scrambled(lpq::Index n, lpq::Index m, int turns, std::uint64_t seed) {
  using lpq::Index;
  lpq::QuadMesh mesh = grid(n, m);
  lpq::Rng rng(seed);
  for (int turn = 0; turn < turns; ++turn) {
    lpq::Face& a = mesh.faces[rng.below(mesh.faces.size())];
    const Index k = static_cast<Index>(rng.below(4)), p = a[k], q = a[(k + 1) & 3];
    for (lpq::Face& b : mesh.faces)
      for (Index j = 0; j < 4; ++j)
        if (b[j] == q && b[(j + 1) & 3] == p) {
          // Hexagon q, a+2, a+3, p, b+2, b+3: the edge p q becomes a+2, b+2.
          const Index a2 = a[(k + 2) & 3], a3 = a[(k + 3) & 3];
          const Index b2 = b[(j + 2) & 3], b3 = b[(j + 3) & 3];
          if (a2 == b2 || a2 == b3 || a3 == b2 || a3 == b3) continue;
          a = {a2, a3, p, b2};
          b = {b2, b3, q, a2};
        }
  }
  return mesh;
}

/// Axis-parallel crosses and size h everywhere in a box around the points.
inline lpq::Fields uniform_fields(const lpq::QuadMesh& mesh, double h) {
  double size = h;
  for (const lpq::Vec2 p : mesh.points)
    size = std::max({size, 2 * std::abs(p.x), 2 * std::abs(p.y)});
  lpq::Fields fields;
  fields.background.points = {{-size, -size}, {size, -size}, {size, size}, {-size, size}};
  fields.background.triangles = {{0, 1, 2}, {0, 2, 3}};
  fields.background.twins = {-1, -1, 3, 2, -1, -1};
  fields.background.region = {0, 0};
  fields.background.fixed = 4;
  fields.z.assign(4, {1, 0});
  fields.h.assign(4, h);
  fields.attach();
  return fields;
}

}  // namespace lpq_test

// Hand-made meshes for tests: triangulations from plain lists, grids, random flips.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "base/rng.h"
#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"
#include "recombine/edit.h"

namespace lpq_test {

using Wall = std::array<lpq::Index, 2>;

/// Links the triangles; `walls` are undirected edges that get no twins.
inline lpq::TriMesh make_tri_mesh(std::vector<lpq::Vec2> points, std::vector<lpq::Tri> triangles,
                                  lpq::Index fixed, const std::vector<Wall>& walls = {}) {
  using lpq::Index;
  lpq::TriMesh mesh;
  mesh.points = std::move(points);
  mesh.triangles = std::move(triangles);
  mesh.fixed = fixed;
  mesh.region.assign(mesh.triangles.size(), 0);
  mesh.twins.assign(3 * mesh.triangles.size(), lpq::none);
  std::map<std::pair<Index, Index>, Index> half_edge;
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e)
    half_edge[{mesh.origin(e), mesh.target(e)}] = e;
  for (const Wall& wall : walls)
    half_edge.erase({wall[0], wall[1]}), half_edge.erase({wall[1], wall[0]});
  for (const auto& [ends, e] : half_edge) {
    const auto twin = half_edge.find({ends.second, ends.first});
    if (twin != half_edge.end()) mesh.twins[e] = twin->second;
  }
  return mesh;
}

/// Vertices of an nx x ny grid inside the unit square, boundary vertices first. The cells' size is
/// a power of two, so that exactly collinear vertices stay so.
struct GridPoints {
  std::vector<lpq::Vec2> points;
  std::vector<lpq::Index> at;  // (nx + 1) (ny + 1)  number of the vertex in column i, row j
  lpq::Index fixed = 0;
  int nx, ny;

  GridPoints(int nx_in, int ny_in)
      : at((nx_in + 1) * (ny_in + 1), lpq::none), nx(nx_in), ny(ny_in) {
    double h = 1;
    while (h * std::max(nx, ny) > 1) h /= 2;
    for (const bool rim : {true, false}) {
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
          if ((i == 0 || j == 0 || i == nx || j == ny) != rim) continue;
          at[index(i, j)] = static_cast<lpq::Index>(points.size());
          points.push_back({i * h, j * h});
        }
      if (rim) fixed = static_cast<lpq::Index>(points.size());
    }
  }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * (nx + 1) + i); }
  lpq::Index operator()(int i, int j) const { return at[index(i, j)]; }
};

/// Every cell cut by the diagonal from lower left to upper right, or alternately ("union jack").
inline lpq::TriMesh grid_triangles(int nx, int ny, bool alternate = false,
                                   const std::vector<Wall>& walls = {}) {
  const GridPoints grid(nx, ny);
  std::vector<lpq::Tri> triangles;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const lpq::Index a = grid(i, j), b = grid(i + 1, j), c = grid(i + 1, j + 1),
                       d = grid(i, j + 1);
      if (alternate && (i + j) % 2 == 1) {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      } else {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    }
  return make_tri_mesh(grid.points, triangles, grid.fixed, walls);
}

inline lpq::QuadMesh grid_quads(int nx, int ny) {
  const GridPoints grid(nx, ny);
  lpq::QuadMesh mesh;
  mesh.points = grid.points;
  mesh.fixed = grid.fixed;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      mesh.faces.push_back({grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1)});
  mesh.region.assign(mesh.faces.size(), 0);
  return mesh;
}

/// Random flips of inner edges between strictly convex pairs.
inline void shuffle_edges(lpq::TriMesh& mesh, lpq::Rng& rng, int flips) {
  for (int k = 0; k < flips; ++k) {
    const auto e = static_cast<lpq::Index>(rng.below(mesh.twins.size()));
    if (lpq::is_flippable(mesh, e)) lpq::flip_edge(mesh, e);
  }
}

/// Moves the free vertices by up to `amount`, where all triangles stay counter-clockwise.
inline void jitter(lpq::TriMesh& mesh, lpq::Rng& rng, double amount) {
  for (lpq::Index v = mesh.fixed; v < mesh.vertex_count(); ++v)
    mesh.points[v] += {rng.between(-amount, amount), rng.between(-amount, amount)};
}

/// Turns inner edge e into a wall.
inline void cut(lpq::TriMesh& mesh, lpq::Index e) {
  if (mesh.twins[e] == lpq::none) return;
  mesh.twins[mesh.twins[e]] = lpq::none;
  mesh.twins[e] = lpq::none;
}

}  // namespace lpq_test

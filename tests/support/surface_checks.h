// What must hold of every surface mesh, and its topology counted from scratch.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/disjoint_sets.h"
#include "catch.h"
#include "mesh/surface_mesh.h"
#include "mesh/walk.h"
#include "surface/soup.h"

namespace lpq_test {

inline double area_of(const std::vector<lpq::Vec3>& points,
                      const std::vector<lpq::Tri>& triangles) {
  double sum = 0;
  for (const lpq::Tri& t : triangles)
    sum += 0.5 * lpq::length(lpq::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
  return sum;
}

/// Signed volume under the triangles; that inside for a closed surface with its outside out.
inline double volume_of(const lpq::SurfaceMesh& mesh) {
  double sum = 0;
  for (const lpq::Tri& t : mesh.triangles)
    sum += lpq::dot(lpq::cross(mesh.points[t[0]], mesh.points[t[1]]), mesh.points[t[2]]) / 6;
  return sum;
}

inline void check_half_edges(const lpq::SurfaceMesh& mesh) {
  using lpq::Index;
  REQUIRE(mesh.twins.size() == 3 * mesh.triangles.size());
  REQUIRE(mesh.group.size() == mesh.triangles.size());
  Index bad = 0;
  std::vector<char> used(mesh.points.size(), 0);
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    bad += mesh.origin(e) < 0 || mesh.origin(e) >= mesh.vertex_count();
    if (bad > 0) break;
    used[mesh.origin(e)] = 1;
    bad += mesh.origin(e) == mesh.target(e);
    const Index twin = mesh.twins[e];
    if (twin == lpq::none) continue;
    bad += mesh.twins[twin] != e || mesh.origin(twin) != mesh.target(e) ||
           mesh.target(twin) != mesh.origin(e);
  }
  CHECK(bad == 0);
  CHECK(std::count(used.begin(), used.end(), 0) == 0);
}

/// No two triangles have the same three corners.
inline void check_no_duplicates(const lpq::SurfaceMesh& mesh) {
  std::vector<lpq::Tri> keys = mesh.triangles;
  for (lpq::Tri& key : keys) std::sort(key.begin(), key.end());
  std::sort(keys.begin(), keys.end());
  CHECK(std::adjacent_find(keys.begin(), keys.end()) == keys.end());
}

struct Topology {
  lpq::Index euler = 0, loops = 0;  // vertices counted once per umbrella
  lpq::Index genus() const { return (2 - euler - loops) / 2; }
};

/// Of every part connected across twins, by the part's first triangle.
inline std::vector<Topology> topology_of(const lpq::SurfaceMesh& mesh) {
  using lpq::Index;
  const Index half_edges = 3 * mesh.triangle_count();
  lpq::DisjointSets parts(mesh.triangle_count()), umbrellas(half_edges), walls(half_edges);
  for (Index e = 0; e < half_edges; ++e) {
    const Index twin = mesh.twins[e];
    if (twin != lpq::none) {
      parts.unite(lpq::triangle_of(e), lpq::triangle_of(twin));
      umbrellas.unite(e, lpq::next_in_triangle(twin));
      continue;
    }
    // The wall that goes on where this one ends, around the same umbrella.
    Index next = lpq::next_in_triangle(e);
    while (mesh.twins[next] != lpq::none) next = lpq::next_in_triangle(mesh.twins[next]);
    walls.unite(e, next);
  }
  std::vector<Index> number(mesh.triangles.size(), lpq::none);
  std::vector<Topology> topology;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    if (parts.root(t) == t) {
      number[t] = static_cast<Index>(topology.size());
      topology.emplace_back();
    }
    Topology& part = topology[number[parts.root(t)]];
    part.euler += 1;
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      part.euler += umbrellas.root(e) == e;
      part.euler -= mesh.twins[e] == lpq::none || mesh.twins[e] > e;
      part.loops += mesh.twins[e] == lpq::none && walls.root(e) == e;
    }
  }
  return topology;
}

/// Every part is an orientable surface: 2 - 2 genus - loops = Euler number.
inline void check_topology(const lpq::SurfaceMesh& mesh) {
  for (const Topology& part : topology_of(mesh)) {
    CHECK((2 - part.euler - part.loops) % 2 == 0);
    CHECK(part.genus() >= 0);
  }
}

inline void check_surface(const lpq::SurfaceMesh& mesh) {
  check_half_edges(mesh);
  check_no_duplicates(mesh);
  check_topology(mesh);
}

}  // namespace lpq_test

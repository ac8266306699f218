// What must hold between a triangulation and a quad mesh made from it.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "mesh/quad_mesh.h"
#include "mesh/tri_mesh.h"
#include "mesh/validate.h"

namespace lpq_test {

using DirectedEdges = std::vector<std::array<lpq::Index, 2>>;

/// Edges with the mesh on the left only.
inline DirectedEdges outer_boundary(const lpq::TriMesh& mesh) {
  DirectedEdges walls, outer;
  for (lpq::Index e = 0; e < 3 * mesh.triangle_count(); ++e)
    if (mesh.twins[e] == lpq::none) walls.push_back({mesh.origin(e), mesh.target(e)});
  std::sort(walls.begin(), walls.end());
  for (const auto& [a, b] : walls)
    if (!std::binary_search(walls.begin(), walls.end(), std::array{b, a})) outer.push_back({a, b});
  return outer;
}

inline DirectedEdges outer_boundary(const lpq::QuadMesh& mesh) {
  DirectedEdges edges, outer;
  for (const lpq::Face& face : mesh.faces)
    for (int k = 0, n = lpq::corner_count(face); k < n; ++k)
      edges.push_back({face[k], face[(k + 1) % n]});
  std::sort(edges.begin(), edges.end());
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::array{b, a})) outer.push_back({a, b});
  return outer;
}

/// What is wrong wherever the free vertices are, in meshes that still wait for smoothing: edges,
/// fans, boundary, walls, use of vertices.
inline std::vector<lpq::Violation> topology_faults(const lpq::QuadMesh& mesh,
                                                   const lpq::ExpectedBoundary& boundary) {
  std::vector<lpq::Violation> found = lpq::validate(mesh, boundary, 1'000'000);
  std::erase_if(found, [](const lpq::Violation& violation) {
    return violation.what.find("not strictly convex") != std::string::npos ||
           violation.what.find("coincide") != std::string::npos;
  });
  return found;
}

/// All sentences, for a readable failure; empty when there is none.
inline std::string sentences(const std::vector<lpq::Violation>& violations) {
  std::string text;
  for (const lpq::Violation& violation : violations) text += violation.what + "\n";
  return text;
}

inline double signed_area(const lpq::QuadMesh& mesh) {
  double twice = 0;
  for (const lpq::Face& face : mesh.faces)
    for (int k = 0, n = lpq::corner_count(face); k < n; ++k)
      twice += lpq::cross(mesh.points[face[k]], mesh.points[face[(k + 1) % n]]);
  return twice / 2;
}

inline double signed_area(const lpq::TriMesh& mesh) {
  double twice = 0;
  for (const lpq::Tri& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) twice += lpq::cross(mesh.points[t[k]], mesh.points[t[(k + 1) % 3]]);
  return twice / 2;
}

}  // namespace lpq_test

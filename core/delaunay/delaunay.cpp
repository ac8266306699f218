// The two constructions from scratch: order the points along a Hilbert curve, insert them, force
// the boundary's edges, carve. See whole_plane.h for the steps and their costs.
#include "delaunay/delaunay.h"

#include <string>

#include "delaunay/hilbert.h"
#include "delaunay/whole_plane.h"

namespace lpq {
namespace {

Problem triangulate_plane(std::span<const Vec2> points, WholePlane& plane) {
  if (points.size() < 3) {
    Error error;
    error.code = ErrorCode::too_few_points;
    error.message = "Fewer than three points cannot be triangulated.";
    return error;
  }
  plane.given = hilbert_order(points);
  plane.points.resize(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) plane.points[v] = points[plane.given[v]];
  return insert_all(plane, insertion_rounds(static_cast<Index>(points.size())));
}

// A vertex in no triangle was carved away with the outside.
Problem find_unused(const TriMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const Tri& t : mesh.triangles) {
    for (const Index v : t) used[v] = 1;
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (used[v]) continue;
    Error error;
    error.code = ErrorCode::hole_outside;
    error.message = v < mesh.fixed ? "Boundary point " + std::to_string(v)
                                   : "Interior point " + std::to_string(v - mesh.fixed);
    error.message += " lies outside the domain.";
    error.where.set_point(mesh.points[v].x, mesh.points[v].y);
    return error;
  }
  return std::nullopt;
}

}  // namespace

Result<TriMesh> triangulate(std::span<const Vec2> points) {
  WholePlane plane;
  if (auto error = triangulate_plane(points, plane)) return *std::move(error);
  TriMesh mesh = without_ghosts(std::move(plane));
  mesh.points.assign(points.begin(), points.end());
  mesh.fixed = mesh.vertex_count();
  return mesh;
}

Result<TriMesh> triangulate(const BoundaryMesh& boundary, std::span<const Vec2> interior) {
  const Index fixed = static_cast<Index>(boundary.points.size());
  std::vector<Vec2> points;
  points.reserve(boundary.points.size() + interior.size());
  points.insert(points.end(), boundary.points.begin(), boundary.points.end());
  points.insert(points.end(), interior.begin(), interior.end());
  WholePlane plane;
  if (auto error = triangulate_plane(points, plane)) return *std::move(error);
  if (auto error = insert_segments(plane, boundary.edges, fixed)) return *std::move(error);
  TriMesh mesh = carve(std::move(plane), boundary.edges);
  mesh.points = std::move(points);
  mesh.fixed = fixed;
  if (auto error = find_unused(mesh)) return *std::move(error);
  return mesh;
}

}  // namespace lpq

#include "cleanup/quad_topology.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

// Coordinates of the unit frame are rounded to 1e-16: a corner lower than this over its longer side
// may have no height at all in the caller's coordinates.
constexpr double least_height = 1e-14;

constexpr Face dead_face{none, none, none, none};

}  // namespace

QuadTopology::QuadTopology(QuadMesh mesh) : mesh_(std::move(mesh)) {
  std::vector<Index> count(mesh_.points.size(), 0);
  for (const Face& face : mesh_.faces)
    for (int k = 0; k < corner_count(face); ++k) ++count[face[k]];
  faces_of_.resize(mesh_.points.size());
  for (std::size_t v = 0; v < count.size(); ++v) faces_of_[v].reserve(count[v]);
  for (Index f = 0; f < face_slots(); ++f)
    for (int k = 0; k < corner_count(face(f)); ++k) faces_of_[face(f)[k]].push_back(f);
}

bool QuadTopology::is_wall(Index a, Index b) const {
  if (a > b) std::swap(a, b);
  if (b >= mesh_.fixed) return false;
  return std::binary_search(mesh_.walls.begin(), mesh_.walls.end(), std::array<Index, 2>{a, b});
}

Index QuadTopology::face_with_edge(Index a, Index b) const {
  for (const Index f : faces_of_[a]) {
    const Face& corners = mesh_.faces[f];
    if (next_corner(corners, corner_of(corners, a)) == b) return f;
  }
  return none;
}

void QuadTopology::move(Index v, Vec2 position) {
  LPQ_ASSERT(!is_fixed(v));
  mesh_.points[v] = position;
}

Index QuadTopology::add_vertex(Vec2 position) {
  mesh_.points.push_back(position);
  faces_of_.emplace_back();
  return vertex_count() - 1;
}

Index QuadTopology::add_face(const Face& face, Index region) {
  const Index f = face_slots();
  mesh_.faces.push_back(face);
  if (!mesh_.region.empty()) mesh_.region.push_back(region);
  for (int k = 0; k < corner_count(face); ++k) faces_of_[face[k]].push_back(f);
  return f;
}

void QuadTopology::remove_face(Index f) {
  LPQ_ASSERT(is_alive(f));
  Face& corners = mesh_.faces[f];
  for (int k = 0; k < corner_count(corners); ++k) {
    std::vector<Index>& list = faces_of_[corners[k]];
    list.erase(std::find(list.begin(), list.end(), f));
  }
  corners = dead_face;
}

QuadMesh QuadTopology::compact() && {
  std::vector<Index> renamed(mesh_.points.size(), none);
  Index vertices = 0;
  for (Index v = 0; v < vertex_count(); ++v) {
    if (!is_fixed(v) && faces_of_[v].empty()) continue;
    mesh_.points[vertices] = mesh_.points[v];
    renamed[v] = vertices++;
  }
  mesh_.points.resize(vertices);
  Index faces = 0;
  for (Index f = 0; f < face_slots(); ++f) {
    if (!is_alive(f)) continue;
    Face face = mesh_.faces[f];
    for (int k = 0; k < corner_count(mesh_.faces[f]); ++k) face[k] = renamed[face[k]];
    mesh_.faces[faces] = face;
    if (!mesh_.region.empty()) mesh_.region[faces] = mesh_.region[f];
    ++faces;
  }
  mesh_.faces.resize(faces);
  if (!mesh_.region.empty()) mesh_.region.resize(faces);
  return std::move(mesh_);
}

Index corner_of(const Face& face, Index v) {
  for (Index k = 0; k < 4; ++k)
    if (face[k] == v) return k;
  return none;
}

Csr<Index> faces_at_vertices(const QuadMesh& mesh) {
  return csr_from<Index>(mesh.points.size(), [&](auto&& emit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
        emit(mesh.faces[f][k], static_cast<Index>(f));
  });
}

bool is_strictly_convex(std::span<const Vec2> points, const Face& face) {
  const int n = corner_count(face);
  for (int k = 0; k < n; ++k) {
    const Vec2 a = points[face[k]], b = points[face[(k + 1) % n]], c = points[face[(k + 2) % n]];
    if (orient2d(a, b, c) <= 0) return false;
    const double twice_area = cross(b - a, c - b);
    const double longest = std::max(squared_length(b - a), squared_length(c - b));
    if (twice_area * twice_area <= least_height * least_height * longest) return false;
  }
  return true;
}

}  // namespace lpq

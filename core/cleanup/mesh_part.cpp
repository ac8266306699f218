#include "cleanup/mesh_part.h"

#include <algorithm>
#include <utility>

#include "base/sort_numbers.h"
#include "base/sort_unique.h"

namespace lpq {

MeshPart extract_part(const QuadMesh& whole, const Csr<Index>& stars,
                      const std::vector<Index>& faces) {
  MeshPart part;
  std::vector<Index> vertices;
  for (const Index f : faces)
    for (int k = 0; k < corner_count(whole.faces[f]); ++k) vertices.push_back(whole.faces[f][k]);
  sort_unique(vertices);
  const auto inside = [&](Index f) { return std::binary_search(faces.begin(), faces.end(), f); };
  const auto moves = [&](Index v) {
    const auto star = stars.row(v);
    return v >= whole.fixed && std::all_of(star.begin(), star.end(), inside);
  };
  for (const Index v : vertices)
    if (!moves(v)) part.vertex.push_back(v);
  part.mesh.fixed = static_cast<Index>(part.vertex.size());
  for (const Index v : vertices)
    if (moves(v)) part.vertex.push_back(v);
  std::vector<Index> local(vertices.size());
  for (std::size_t i = 0; i < part.vertex.size(); ++i) {
    local[index_of(part.vertex[i], vertices)] = static_cast<Index>(i);
    part.mesh.points.push_back(whole.points[part.vertex[i]]);
  }
  for (const Index f : faces) {
    Face face = whole.faces[f];
    for (int k = 0; k < corner_count(whole.faces[f]); ++k)
      face[k] = local[index_of(face[k], vertices)];
    part.mesh.faces.push_back(face);
  }
  return part;
}

void put_back(const MeshPart& part, QuadMesh& whole) {
  for (std::size_t i = part.mesh.fixed; i < part.vertex.size(); ++i)
    whole.points[part.vertex[i]] = part.mesh.points[i];
}

std::vector<std::vector<Index>> face_clusters(const QuadMesh& mesh, const Csr<Index>& stars,
                                              const std::vector<Index>& seeds, int rings) {
  std::vector<char> inside(mesh.faces.size(), 0);
  std::vector<Index> front = seeds, all = seeds;
  const auto take_ring = [&](Index f, std::vector<Index>& next, char from, char to) {
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
      for (const Index g : stars.row(mesh.faces[f][k]))
        if (inside[g] == from) {
          inside[g] = to;
          next.push_back(g);
        }
  };
  for (const Index f : seeds) inside[f] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<Index> next;
    for (const Index f : front) take_ring(f, next, 0, 1);
    all.insert(all.end(), next.begin(), next.end());
    front = std::move(next);
  }
  std::vector<std::vector<Index>> result;
  for (const Index seed : all) {
    if (inside[seed] != 1) continue;
    std::vector<Index> cluster{seed};
    inside[seed] = 2;
    for (std::size_t i = 0; i < cluster.size(); ++i) take_ring(cluster[i], cluster, 1, 2);
    std::sort(cluster.begin(), cluster.end());
    result.push_back(std::move(cluster));
  }
  return result;
}

}  // namespace lpq

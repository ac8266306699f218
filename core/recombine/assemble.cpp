// A corner that is not at an end of a split fan is replaced everywhere in that fan, whatever its
// triangle turns into, so an edge inside two split fans (one at each of its ends) gets both new
// vertices on either side: interacting extra edges need no special case.
#include "recombine/assemble.h"

#include <algorithm>

#include "base/sort_numbers.h"
#include "mesh/walk.h"

namespace lpq {
namespace {

class Assembler {
 public:
  Assembler(const TriMesh& mesh, const Fans& fans, const Pairing& pairing)
      : mesh_(mesh), fans_(fans), pairing_(pairing) {
    result_.points = mesh.points;
    result_.fixed = mesh.fixed;
    corner_vertex_.resize(3 * mesh.triangles.size());
    for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) corner_vertex_[e] = mesh.origin(e);
    new_vertex_.assign(fans.list.size(), none);
  }

  QuadMesh run() {
    for (Index t = 0; t < mesh_.triangle_count(); ++t)
      if (pairing_.split[t] != none && new_vertex_[pairing_.split[t]] == none)
        split_fan(pairing_.split[t]);
    for (Index t = 0; t < mesh_.triangle_count(); ++t) emit(t);
    result_.walls = inner_walls(mesh_);
    return std::move(result_);
  }

 private:
  void split_fan(Index f) {
    const Fan& fan = fans_.list[f];
    const auto vertex = static_cast<Index>(result_.points.size());
    Vec2 sum = mesh_.points[mesh_.origin(fan.first)];
    for_each_in_fan(mesh_, fan.first, [&](Index e) {
      if (e == fan.first) return;
      sum +=
          mesh_
              .points[mesh_.target(e)];  // neighbours along inner edges: the star of the new vertex
      if (e != fan.last) corner_vertex_[e] = vertex;
    });
    result_.points.push_back((1.0 / fan.triangles) * sum);
    new_vertex_[f] = vertex;
  }

  void emit(Index t) {
    if (pairing_.split[t] != none) return emit_end(t, pairing_.split[t]);
    const Index e = pairing_.merge[t];
    if (e == none) {
      return push(
          {corner_vertex_[3 * t], corner_vertex_[3 * t + 1], corner_vertex_[3 * t + 2], none}, t);
    }
    const Index twin = mesh_.twins[e];
    if (triangle_of(twin) < t) return;
    push({corner_vertex_[prev_in_triangle(e)], corner_vertex_[e],
          corner_vertex_[prev_in_triangle(twin)], corner_vertex_[next_in_triangle(e)]},
         t);
  }

  void emit_end(Index t, Index f) {
    const bool is_first = triangle_of(fans_.list[f].first) == t;
    const Index e = is_first ? fans_.list[f].first : fans_.list[f].last;
    const Index v = corner_vertex_[e], v_new = new_vertex_[f];
    const Index target = corner_vertex_[next_in_triangle(e)],
                apex = corner_vertex_[prev_in_triangle(e)];
    push(is_first ? Face{v, target, apex, v_new} : Face{v, v_new, target, apex}, t);
  }

  void push(Face face, Index t) {
    const int corners = corner_count(face);
    std::rotate(face.begin(), std::min_element(face.begin(), face.begin() + corners),
                face.begin() + corners);
    result_.faces.push_back(face);
    result_.region.push_back(mesh_.region[t]);
  }

  const TriMesh& mesh_;
  const Fans& fans_;
  const Pairing& pairing_;
  QuadMesh result_;
  std::vector<Index> corner_vertex_;  // 3 #T  vertex at each half-edge's origin after the splits
  std::vector<Index> new_vertex_;     // #fans
};

}  // namespace

QuadMesh assemble(const TriMesh& mesh, const Fans& fans, const Pairing& pairing) {
  return Assembler(mesh, fans, pairing).run();
}

std::vector<std::array<Index, 2>> inner_walls(const TriMesh& mesh) {
  std::vector<std::array<Index, 3>> sides;  // low, high, which direction
  for (Index e = 0; e < 3 * mesh.triangle_count(); ++e) {
    if (mesh.twins[e] != none) continue;
    const Index a = mesh.origin(e), b = mesh.target(e);
    sides.push_back({std::min(a, b), std::max(a, b), a < b ? 0 : 1});
  }
  sort_values(sides);
  std::vector<std::array<Index, 2>> walls;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i][0] == sides[i - 1][0] && sides[i][1] == sides[i - 1][1])
      walls.push_back({sides[i][0], sides[i][1]});
  return walls;
}

}  // namespace lpq

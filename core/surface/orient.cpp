#include "surface/orient.h"

#include <algorithm>
#include <span>
#include <utility>

#include "surface/edges.h"

namespace lpq {
namespace {

// Cosine of the angle between the normals of two triangles that are one sheet beneath a third.
constexpr double straight_on = 0.5;

class Orienter {
 public:
  explicit Orienter(SurfaceMesh& mesh)
      : mesh_(mesh), edges_(surface_edges(mesh.triangles, mesh.vertex_count())) {}

  Orientation run() {
    turned_.assign(mesh_.triangles.size(), 0);
    reached_.assign(mesh_.triangles.size(), 0);
    component_.assign(mesh_.triangles.size(), none);
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      if (reached_[t]) continue;
      grow(t);
      settle();
      ++result_.components;
    }
    turn_triangles();
    link();
    count_pinched();
    return result_;
  }

 private:
  /// The half-edge across an edge of exactly two triangles, else none.
  Index partner(Index e) const {
    const auto around = edges_.half_edges.row(edges_.edge_of[e]);
    if (around.size() != 2) return none;
    return around[0] == e ? around[1] : around[0];
  }
  bool runs_the_same_way(Index e, Index f) const { return mesh_.origin(e) == mesh_.origin(f); }

  void grow(Index seed) {
    part_.assign(1, seed);
    reached_[seed] = 1;
    for (std::size_t head = 0; head < part_.size(); ++head) {
      const Index t = part_[head];
      for (Index e = 3 * t; e < 3 * t + 3; ++e) {
        const Index f = partner(e);
        if (f == none || reached_[triangle_of(f)]) continue;
        const Index other = triangle_of(f);
        reached_[other] = 1;
        turned_[other] = runs_the_same_way(e, f) ? !turned_[t] : turned_[t];
        part_.push_back(other);
      }
    }
  }

  bool agree(Index e, Index f) const {
    const bool equal = turned_[triangle_of(e)] == turned_[triangle_of(f)];
    return runs_the_same_way(e, f) != equal;
  }

  /// Which of the two orientations of a part it gets.
  void settle() {
    std::size_t turned = 0;
    bool closed = true;
    for (const Index t : part_) {
      component_[t] = result_.components;
      turned += turned_[t];
      for (Index e = 3 * t; e < 3 * t + 3; ++e) {
        const Index f = partner(e);
        closed = closed && f != none && agree(e, f);
      }
    }
    if (turned == 0) return;
    if (!(closed ? volume() < 0 : 2 * turned > part_.size())) return;
    for (const Index t : part_) turned_[t] = !turned_[t];
  }

  /// Six times the volume inside a closed part.
  double volume() const {
    const Vec3 origin = mesh_.points[mesh_.triangles[part_[0]][0]];
    double sum = 0;
    for (const Index t : part_) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const Vec3 u = mesh_.points[a] - origin, v = mesh_.points[b] - origin;
      const double six = dot(cross(u, v), mesh_.points[c] - origin);
      sum += turned_[t] ? -six : six;
    }
    return sum;
  }

  void turn_triangles() {
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      if (!turned_[t]) continue;
      std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
      ++result_.turned;
    }
    if (result_.turned > 0) edges_ = surface_edges(mesh_.triangles, mesh_.vertex_count());
  }

  void link() {
    mesh_.twins.assign(3 * mesh_.triangles.size(), none);
    for (Index i = 0; i < edges_.count(); ++i) {
      const auto around = edges_.half_edges.row(i);
      if (around.size() == 1) {
        ++result_.borders;
      } else if (around.size() > 2) {
        ++result_.nonmanifold;
        if (around.size() == 3) link_straightest(around);
      } else if (runs_the_same_way(around[0], around[1])) {
        ++result_.conflicts;
      } else {
        link(around[0], around[1]);
      }
    }
  }
  void link(Index e, Index f) {
    mesh_.twins[e] = f;
    mesh_.twins[f] = e;
  }

  /// A sheet goes on beneath another that ends on it: else it would have a slit there, whose sides
  /// lie on each other in any plane. Of one part only, as parts have orientations of their own.
  void link_straightest(std::span<const Index> around) {
    Index best_e = none, best_f = none;
    double best = straight_on;
    for (const Index e : around)
      for (const Index f : around) {
        if (f <= e || mesh_.twins[e] != none || mesh_.twins[f] != none) continue;
        if (component_[triangle_of(e)] != component_[triangle_of(f)] || runs_the_same_way(e, f))
          continue;
        const Vec3 m = normal(e), n = normal(f);
        const double cosine = dot(m, n) / std::max(length(m) * length(n), 1e-300);
        if (!(cosine > best)) continue;
        best = cosine;
        best_e = e;
        best_f = f;
      }
    if (best_e != none) link(best_e, best_f);
  }

  Vec3 normal(Index e) const {
    const Vec3 a = mesh_.points[mesh_.origin(e)];
    return cross(mesh_.points[mesh_.target(e)] - a, mesh_.points[mesh_.apex(e)] - a);
  }

  void count_pinched() {
    const auto pinched = pinched_vertices(mesh_.triangles, edges_, mesh_.vertex_count());
    result_.pinched_vertices = static_cast<Index>(std::count(pinched.begin(), pinched.end(), 1));
  }

  SurfaceMesh& mesh_;
  SurfaceEdges edges_;
  std::vector<char> turned_, reached_;  // #T
  std::vector<Index> component_;        // #T
  std::vector<Index> part_;             // triangles of the part being judged
  Orientation result_;
};

}  // namespace

Orientation orient_surface(SurfaceMesh& mesh) { return Orienter(mesh).run(); }

}  // namespace lpq

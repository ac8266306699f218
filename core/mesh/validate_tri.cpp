// The exact check of a triangulation. Cost O(#T).
#include <string>

#include "geometry/predicates.h"
#include "mesh/validate.h"

namespace lpq {
namespace {

class TriChecker {
 public:
  TriChecker(const TriMesh& mesh, std::size_t limit) : mesh_(mesh), limit_(limit) {}

  std::vector<Violation> run() {
    if (check_sizes()) {
      for (Index t = 0; t < mesh_.triangle_count(); ++t) check_triangle(t);
      if (found_.empty()) check_fans();
    }
    return std::move(found_);
  }

 private:
  void report(std::string what, Index face, Index vertex) {
    if (found_.size() >= limit_) return;
    Violation violation;
    violation.what = std::move(what);
    violation.face = face;
    violation.vertex = vertex;
    if (vertex != none) violation.point = mesh_.points[vertex];
    found_.push_back(std::move(violation));
  }

  // Without right sizes and indices nothing else can be looked at.
  bool check_sizes() {
    const std::size_t count = mesh_.triangles.size();
    if (mesh_.twins.size() != 3 * count || mesh_.region.size() != count || mesh_.fixed < 0 ||
        mesh_.fixed > mesh_.vertex_count()) {
      report("The arrays of the mesh have different lengths.", none, none);
      return false;
    }
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      for (Index k = 0; k < 3; ++k) {
        const Index v = mesh_.triangles[t][k], twin = mesh_.twins[3 * t + k];
        if (v < 0 || v >= mesh_.vertex_count() || twin < none ||
            twin >= 3 * mesh_.triangle_count()) {
          report("An index is out of range.", t, none);
          return false;
        }
      }
    }
    return true;
  }

  void check_triangle(Index t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    if (orient2d(mesh_.points[a], mesh_.points[b], mesh_.points[c]) <= 0) {
      report("The triangle is not counter-clockwise.", t, a);
    }
    if (mesh_.region[t] < 0) report("The triangle has no region.", t, a);
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      const Index twin = mesh_.twins[e];
      if (twin == none) continue;
      if (mesh_.twins[twin] != e || mesh_.origin(twin) != mesh_.target(e) ||
          mesh_.target(twin) != mesh_.origin(e)) {
        report("The half-edge and its twin do not match.", t, mesh_.origin(e));
      } else if (mesh_.region[triangle_of(twin)] != mesh_.region[t]) {
        report("Two regions meet at an edge that is not a wall.", t, mesh_.origin(e));
      }
    }
  }

  // Around a free vertex the triangles close in one ring without a wall.
  void check_fans() {
    std::vector<Index> corners(mesh_.points.size(), 0);
    for (const Tri& t : mesh_.triangles) {
      for (const Index v : t) ++corners[v];
    }
    const std::vector<Index> leaving = outgoing_half_edges(mesh_);
    for (Index v = mesh_.fixed; v < mesh_.vertex_count(); ++v) {
      if (leaving[v] == none) {
        report("The free vertex is in no triangle.", none, v);
        continue;
      }
      Index e = leaving[v], ring = 0;
      do {
        e = mesh_.twins[prev_in_triangle(e)];
        ++ring;
      } while (e != none && e != leaving[v] && ring <= corners[v]);
      if (e == none) {
        report("The free vertex touches a wall.", none, v);
      } else if (ring != corners[v]) {
        report("The triangles around the free vertex are not one fan.", none, v);
      }
    }
  }

  const TriMesh& mesh_;
  std::size_t limit_;
  std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> validate(const TriMesh& mesh, std::size_t limit) {
  return TriChecker(mesh, limit).run();
}

}  // namespace lpq

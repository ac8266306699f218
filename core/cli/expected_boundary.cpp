// See expected_boundary.h.
#include "cli/expected_boundary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/csr.h"
#include "base/sort_unique.h"

namespace lpq {
namespace {

using DirectedEdge = std::array<Index, 2>;

std::vector<DirectedEdge> face_sides(const OutputMesh& mesh) {
  std::vector<DirectedEdge> sides;
  for (const Face& face : mesh.faces) {
    const int n = corner_count(face);
    for (int k = 0; k < n; ++k) sides.push_back({face[k], face[(k + 1) % n]});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

class Matcher {
 public:
  Matcher(const Domain& domain, const OutputMesh& mesh) : domain_(domain), mesh_(mesh) {
    sort_points();
    collect_neighbours();
  }

  Result<BoundaryMatch> match() {
    // Points inside belong to no segment.
    for (Index p = 0; p < static_cast<Index>(domain_.given.size()); ++p)
      if (find_point(p) == none)
        return missing("A domain point is not a vertex of the mesh.",
                       domain_.given[static_cast<std::size_t>(p)]);
    for (const Segment& segment : domain_.segments) {
      if (!follow(segment, find_point(segment.a), find_point(segment.b))) {
        return missing("A domain edge is not made of mesh edges.",
                       domain_.given[static_cast<std::size_t>(segment.a)]);
      }
    }
    std::sort(result_.walls.begin(), result_.walls.end());
    return std::move(result_);
  }

 private:
  static Error missing(const char* message, Vec2 at) {
    Error error{ErrorCode::no_valid_mesh, message, {}};
    error.where.set_point(at.x, at.y);
    return error;
  }

  Vec2 point(Index v) const { return mesh_.points[static_cast<std::size_t>(v)]; }

  void sort_points() {
    sorted_.resize(mesh_.points.size());
    std::iota(sorted_.begin(), sorted_.end(), 0);
    std::sort(sorted_.begin(), sorted_.end(),
              [&](Index a, Index b) { return point(a) == point(b) ? a < b : point(a) < point(b); });
  }

  void collect_neighbours() {
    std::vector<DirectedEdge> sides = face_sides(mesh_);
    const std::size_t count = sides.size();
    for (std::size_t i = 0; i < count; ++i) sides.push_back({sides[i][1], sides[i][0]});
    sort_unique(sides);
    std::size_t next = 0;
    for (Index v = 0; v < static_cast<Index>(mesh_.points.size()); ++v) {
      while (next < sides.size() && sides[next][0] == v)
        neighbours_.values.push_back(sides[next++][1]);
      neighbours_.end_row();
    }
  }

  Index find_point(Index domain_point) const {
    const Vec2 p = domain_.given[static_cast<std::size_t>(domain_point)];
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), p,
                                     [&](Index v, Vec2 q) { return point(v) < q; });
    return at != sorted_.end() && point(*at) == p ? *at : none;
  }

  /// Walks from a to b along mesh edges that stay on the segment.
  bool follow(const Segment& segment, Index a, Index b) {
    const Vec2 start = point(a), end = point(b), direction = end - start;
    const double size =
        std::max({std::fabs(start.x), std::fabs(start.y), std::fabs(end.x), std::fabs(end.y)});
    // A point on the segment rounded to doubles is off by an ulp of its coordinates; computing it
    // costs a few roundings more.
    constexpr double roundings = 16;
    const double slack = roundings * 0x1p-52 * size * length(direction);
    int steps = 0;
    for (Index v = a; v != b; ++steps) {
      const Index next = next_on_line(v, b, direction, start, slack);
      if (next == none) return false;
      add_edge(segment, v, next);
      v = next;
    }
    ++(steps == 1 ? result_.kept : result_.divided);
    return true;
  }

  Index next_on_line(Index v, Index goal, Vec2 direction, Vec2 start, double slack) const {
    Index best = none;
    double least = 0;
    for (const Index w : neighbours_.row(v)) {
      if (w == goal) return w;
      const double progress = dot(point(w) - point(v), direction);
      if (progress <= 0 || dot(point(goal) - point(w), direction) <= 0) continue;
      const double offset = std::fabs(cross(direction, point(w) - start));
      if (offset > slack) continue;
      // In a sharp corner two walls may pass for this one near their common end: the straighter is.
      if (best == none || offset < least * progress) {
        best = w;
        least = offset / progress;
      }
    }
    return best;
  }

  void add_edge(const Segment& segment, Index a, Index b) {
    if (segment.left != none && segment.right == none) {
      result_.outline.push_back({a, b});
    } else if (segment.left == none && segment.right != none) {
      result_.outline.push_back({b, a});
    } else {
      result_.walls.push_back({std::min(a, b), std::max(a, b)});
    }
  }

  const Domain& domain_;
  const OutputMesh& mesh_;
  std::vector<Index> sorted_;  // mesh points in lexicographic order
  Csr<Index> neighbours_;
  BoundaryMatch result_;
};

}  // namespace

Result<BoundaryMatch> match_boundary(const Domain& domain, const OutputMesh& mesh) {
  return Matcher(domain, mesh).match();
}

std::vector<DirectedEdge> own_outline(const OutputMesh& mesh) {
  const std::vector<DirectedEdge> sides = face_sides(mesh);
  std::vector<DirectedEdge> outline;
  for (const DirectedEdge& side : sides) {
    if (!std::binary_search(sides.begin(), sides.end(), DirectedEdge{side[1], side[0]})) {
      outline.push_back(side);
    }
  }
  return outline;
}

}  // namespace lpq

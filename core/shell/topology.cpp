// See topology.h.
#include "shell/topology.h"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"
#include "shell/shape/space_energy.h"
#include "shell/sides.h"
#include "surface/weld.h"

namespace lpq {
namespace {

Index count_sets(DisjointSets& sets, std::span<const char> used) {
  Index count = 0;
  for (Index i = 0; i < static_cast<Index>(used.size()); ++i) count += used[i] && sets.root(i) == i;
  return count;
}

class Counter {
 public:
  explicit Counter(std::span<const Face> faces)
      : faces_(faces),
        sides_(sides_by_edge(faces)),
        parts_(static_cast<Index>(faces.size())),
        fans_(4 * static_cast<Index>(faces.size())) {
    for (const FaceSide& side : sides_) vertices_ = std::max(vertices_, side.ends[1] + 1);
  }

  ShellTopology count() {
    DisjointSets borders(vertices_);
    std::vector<char> on_border(static_cast<std::size_t>(vertices_), 0);
    Index edges = 0;
    for_each_edge(sides_, [&](std::span<const FaceSide> on_edge) {
      ++edges;
      for (const FaceSide& side : on_edge.subspan(1)) join(on_edge[0], side);
      result_.meeting_edges += on_edge.size() > 2;
      result_.one_sided_edges += on_edge.size() == 2 && on_edge[0].forward == on_edge[1].forward;
      if (on_edge.size() > 1) return;
      ++result_.border_edges;
      borders.unite(on_edge[0].ends[0], on_edge[0].ends[1]);
      for (const Index v : on_edge[0].ends) on_border[v] = 1;
    });
    result_.borders = count_sets(borders, on_border);
    result_.components = count_sets(parts_, std::vector<char>(faces_.size(), 1));
    count_vertices(edges);
    return result_;
  }

 private:
  /// The faces of two sides of one edge hang together there, and so do their corners at its ends.
  void join(const FaceSide& s, const FaceSide& t) {
    parts_.unite(s.face, t.face);
    for (const Index v : s.ends) fans_.unite(corner_at(faces_, s, v), corner_at(faces_, t, v));
  }

  void count_vertices(Index edges) {
    std::vector<Index> fans(static_cast<std::size_t>(vertices_), 0);
    for (Index f = 0; f < static_cast<Index>(faces_.size()); ++f)
      for (int k = 0; k < corner_count(faces_[f]); ++k)
        fans[faces_[f][k]] += fans_.root(4 * f + k) == 4 * f + k;
    Index used = 0;
    for (const Index count : fans) {
      used += count > 0;
      result_.pinches += count > 1;
    }
    result_.euler = used - edges + static_cast<Index>(faces_.size());
  }

  std::span<const Face> faces_;
  std::vector<FaceSide> sides_;
  Index vertices_ = 0;
  DisjointSets parts_, fans_;  // of faces, of corners 4 f + k
  ShellTopology result_;
};

class FaceCheck {
 public:
  FaceCheck(std::span<const Vec3> points, std::span<const Face> faces, std::size_t limit,
            std::span<const Index> body)
      : points_(points), faces_(faces), limit_(limit), body_(body) {}

  std::vector<Violation> run() {
    for (Index f = 0; f < static_cast<Index>(faces_.size()); ++f) check_corners(f);
    for (Violation& wrong : check_places(points_, faces_, 0, limit_ - violations_.size(), body_))
      violations_.push_back(std::move(wrong));
    return std::move(violations_);
  }

 private:
  void add(const char* what, Index face, Index vertex) {
    if (violations_.size() < limit_) violations_.push_back({what, face, vertex, {}});
  }

  void check_corners(Index f) {
    const Face& face = faces_[f];
    for (int k = 0; k < corner_count(face); ++k)
      for (int j = 0; j < k; ++j)
        if (face[j] == face[k]) return add("A face has a vertex twice.", f, face[k]);
    if (corner_count(face) == 4 &&
        has_reflex_corner(points_[face[0]], points_[face[1]], points_[face[2]], points_[face[3]]))
      add("A quad is not convex.", f, face[0]);
  }

  std::span<const Vec3> points_;
  std::span<const Face> faces_;
  std::size_t limit_;
  std::span<const Index> body_;
  std::vector<Violation> violations_;
};

}  // namespace

bool has_reflex_corner(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return !is_strictly_convex({a, b, c, d}, cross(c - a, d - b));
}

ShellTopology shell_topology(std::span<const Face> faces) { return Counter(faces).count(); }

std::vector<Face> faces_of(std::span<const Tri> triangles) {
  std::vector<Face> faces;
  for (const auto& [a, b, c] : triangles) faces.push_back({a, b, c, none});
  return faces;
}

std::vector<Violation> check_places(std::span<const Vec3> points, std::span<const Face> faces,
                                    double reach, std::size_t limit, std::span<const Index> body) {
  std::vector<Violation> found;
  std::vector<char> used(points.size(), 0);
  std::vector<std::pair<Face, Index>> corners;
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    Face sorted = faces[f];
    for (int k = 0; k < corner_count(faces[f]); ++k) used[faces[f][k]] = 1;
    std::sort(sorted.begin(), sorted.end());
    corners.push_back({sorted, f});
  }
  const std::vector<Index> first = weld_points(points, used, reach, body);
  for (Index v = 0; v < static_cast<Index>(first.size()) && found.size() < limit; ++v)
    if (first[v] != v) found.push_back({"Two vertices lie in the same place.", none, v, {}});
  sort_values(corners);
  for (std::size_t i = 1; i < corners.size() && found.size() < limit; ++i)
    if (corners[i].first == corners[i - 1].first)
      found.push_back({"Two faces have the same vertices.",
                       corners[i].second,
                       faces[corners[i].second][0],
                       {}});
  return found;
}

std::vector<Violation> validate_faces(std::span<const Vec3> points, std::span<const Face> faces,
                                      std::size_t limit, std::span<const Index> body) {
  return FaceCheck(points, faces, limit, body).run();
}

}  // namespace lpq

// See topology.h.
#include "shell/topology.h"

#include <algorithm>
#include <tuple>

#include "base/disjoint_sets.h"
#include "shell/shape/space_energy.h"

namespace lpq {
namespace {

/// A side of a face, filed under its undirected edge.
struct Side {
  std::array<Index, 2> ends{none, none};  // the smaller first
  bool forward = true;                    // runs from the smaller to the larger
  Index face = none;
  int corner = 0;
};

std::vector<Side> sides_of(std::span<const Face> faces) {
  std::vector<Side> sides;
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f)
    for (int k = 0, n = corner_count(faces[f]); k < n; ++k) {
      const Index a = faces[f][k], b = faces[f][(k + 1) % n];
      sides.push_back({{std::min(a, b), std::max(a, b)}, a < b, f, k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tie(s.ends, s.face, s.corner) < std::tie(t.ends, t.face, t.corner);
  });
  return sides;
}

Index count_sets(DisjointSets& sets, std::span<const char> used) {
  Index count = 0;
  for (Index i = 0; i < static_cast<Index>(used.size()); ++i) count += used[i] && sets.root(i) == i;
  return count;
}

class Counter {
 public:
  explicit Counter(std::span<const Face> faces)
      : faces_(faces),
        sides_(sides_of(faces)),
        parts_(static_cast<Index>(faces.size())),
        fans_(4 * static_cast<Index>(faces.size())) {
    for (const Side& side : sides_) vertices_ = std::max(vertices_, side.ends[1] + 1);
  }

  ShellTopology count() {
    DisjointSets borders(vertices_);
    std::vector<char> on_border(static_cast<std::size_t>(vertices_), 0);
    Index edges = 0;
    for (std::size_t i = 0, j = 0; i < sides_.size(); i = j, ++edges) {
      while (j < sides_.size() && sides_[j].ends == sides_[i].ends) ++j;
      for (std::size_t k = i + 1; k < j; ++k) join(sides_[i], sides_[k]);
      result_.meeting_edges += j - i > 2;
      result_.one_sided_edges += j - i == 2 && sides_[i].forward == sides_[i + 1].forward;
      if (j - i > 1) continue;
      ++result_.border_edges;
      borders.unite(sides_[i].ends[0], sides_[i].ends[1]);
      for (const Index v : sides_[i].ends) on_border[v] = 1;
    }
    result_.borders = count_sets(borders, on_border);
    result_.components = count_sets(parts_, std::vector<char>(faces_.size(), 1));
    count_vertices(edges);
    return result_;
  }

 private:
  /// The faces of two sides of one edge hang together there, and so do their corners at its ends.
  void join(const Side& s, const Side& t) {
    parts_.unite(s.face, t.face);
    for (const Index v : s.ends) fans_.unite(corner_at(s, v), corner_at(t, v));
  }

  Index corner_at(const Side& side, Index vertex) const {
    const int next = (side.corner + 1) % corner_count(faces_[side.face]);
    return 4 * side.face + (faces_[side.face][side.corner] == vertex ? side.corner : next);
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
  std::vector<Side> sides_;
  Index vertices_ = 0;
  DisjointSets parts_, fans_;  // of faces, of corners 4 f + k
  ShellTopology result_;
};

class FaceCheck {
 public:
  FaceCheck(std::span<const Vec3> points, std::span<const Face> faces, std::size_t limit)
      : points_(points), faces_(faces), limit_(limit) {}

  std::vector<Violation> run() {
    for (Index f = 0; f < static_cast<Index>(faces_.size()); ++f) check_corners(f);
    check_duplicates();
    check_places();
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

  void check_duplicates() {
    std::vector<std::pair<Face, Index>> keys;
    for (Index f = 0; f < static_cast<Index>(faces_.size()); ++f) {
      Face key = faces_[f];
      std::sort(key.begin(), key.end());
      keys.push_back({key, f});
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < keys.size(); ++i)
      if (keys[i].first == keys[i - 1].first)
        add("Two faces have the same vertices.", keys[i].second, faces_[keys[i].second][0]);
  }

  void check_places() {
    std::vector<Index> order;
    for (const Face& face : faces_)
      for (int k = 0; k < corner_count(face); ++k) order.push_back(face[k]);
    const auto key = [&](Index v) {
      return std::make_tuple(points_[v].x, points_[v].y, points_[v].z, v);
    };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (order[i] != order[i - 1] && points_[order[i]] == points_[order[i - 1]])
        add("Two vertices lie in the same place.", none, order[i]);
  }

  std::span<const Vec3> points_;
  std::span<const Face> faces_;
  std::size_t limit_;
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

std::vector<Violation> validate_faces(std::span<const Vec3> points, std::span<const Face> faces,
                                      std::size_t limit) {
  return FaceCheck(points, faces, limit).run();
}

}  // namespace lpq

// The final check of a quad mesh. One pass over the faces decides the exact signs, one pass over
// the vertices walks each vertex's corners: a corner (v, next, prev, face) stands for the
// half-edges v -> next and prev -> v, so an edge is inside exactly when the corner with the same
// neighbour exists on the other side. Scratch arrays indexed by neighbour keep everything linear.
#include "mesh/validate.h"

#include <algorithm>
#include <cstring>

#include "base/csr.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

struct Corner {
  Index next = none, prev = none, face = none;
};

using DirectedEdge = std::array<Index, 2>;

class Findings {
 public:
  explicit Findings(std::size_t limit) : limit_(limit) {}
  bool full() const { return list_.size() >= limit_; }
  void add(std::string what, Index face = none, Index vertex = none, Vec2 point = {}) {
    if (!full()) list_.push_back({std::move(what), face, vertex, point});
  }
  bool empty() const { return list_.empty(); }
  std::vector<Violation> take() { return std::move(list_); }

 private:
  std::size_t limit_;
  std::vector<Violation> list_;
};

std::string name(Index v) { return std::to_string(v); }
std::string name(Index a, Index b) { return name(a) + "-" + name(b); }

/// Indices, sizes and finite numbers: what every later check takes for granted.
void check_numbers(const QuadMesh& mesh, const ExpectedBoundary& boundary, Findings& found) {
  const auto count = static_cast<Index>(mesh.points.size());
  const auto in_range = [&](Index v) { return v >= 0 && v < count; };
  if (mesh.faces.empty()) found.add("The mesh has no faces.");
  if (mesh.region.size() != mesh.faces.size())
    found.add("The faces and their regions differ in number.");
  if (mesh.fixed < 0 || mesh.fixed > count)
    found.add("The number of fixed vertices is out of range.");
  if (boundary.points.size() > mesh.points.size()) found.add("Given boundary points are missing.");
  for (Index v = 0; v < count; ++v)
    if (!is_finite(mesh.points[v])) found.add("Vertex " + name(v) + " is not finite.", none, v);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < corner_count(mesh.faces[f]); ++k)
      if (!in_range(mesh.faces[f][k]))
        found.add("Face " + std::to_string(f) + " names a vertex that is not there.",
                  static_cast<Index>(f));
  for (const auto& wall : mesh.walls)
    if (!in_range(wall[0]) || !in_range(wall[1]) || wall[0] >= wall[1])
      found.add("A wall does not name two vertices in rising order.");
  for (const DirectedEdge& edge : boundary.edges)
    if (!in_range(edge[0]) || !in_range(edge[1]))
      found.add("An expected boundary edge names a vertex that is not there.");
}

void check_given_points(const QuadMesh& mesh, std::span<const Vec2> given, Findings& found) {
  for (std::size_t v = 0; v < given.size(); ++v) {
    if (std::memcmp(&mesh.points[v], &given[v], sizeof(Vec2)) == 0) continue;
    found.add("Boundary vertex " + std::to_string(v) + " has moved.", none, static_cast<Index>(v),
              mesh.points[v]);
  }
}

/// Four strict left turns add up to a multiple of 2 pi below 4 pi: the quad is simple and convex.
void check_corners(const QuadMesh& mesh, Findings& found) {
  for (std::size_t f = 0; f < mesh.faces.size() && !found.full(); ++f) {
    const Face& face = mesh.faces[f];
    const int corners = corner_count(face);
    for (int k = 0; k < corners; ++k) {
      const Index before = face[(k + corners - 1) % corners], v = face[k],
                  after = face[(k + 1) % corners];
      if (orient2d(mesh.points[before], mesh.points[v], mesh.points[after]) > 0) continue;
      found.add("Face " + std::to_string(f) + " is not strictly convex at vertex " + name(v) + ".",
                static_cast<Index>(f), v, mesh.points[v]);
      break;
    }
  }
}

/// Rows by `key(item)`, items in order.
template <class T, class Key>
Csr<T> group_by(Index rows, std::span<const T> items, Key key) {
  return csr_from<T>(rows, [&](auto&& emit) {
    for (const T& item : items) emit(key(item), item);
  });
}

Csr<Corner> corners_by_vertex(const QuadMesh& mesh) {
  return csr_from<Corner>(mesh.points.size(), [&](auto&& emit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Face& face = mesh.faces[f];
      const int corners = corner_count(face);
      for (int k = 0; k < corners; ++k)
        emit(face[k], Corner{face[(k + 1) % corners], face[(k + corners - 1) % corners],
                             static_cast<Index>(f)});
    }
  });
}

/// Walks the corners of one vertex after another; the scratch arrays are reset after each.
class VertexChecker {
 public:
  VertexChecker(const QuadMesh& mesh, const ExpectedBoundary& boundary, Findings& found)
      : mesh_(mesh), found_(found), corners_(corners_by_vertex(mesh)) {
    const auto count = static_cast<Index>(mesh.points.size());
    arriving_ =
        group_by<DirectedEdge>(count, boundary.edges, [](const DirectedEdge& e) { return e[1]; });
    walls_ = group_by<DirectedEdge>(count, mesh.walls, [](const DirectedEdge& e) { return e[0]; });
    leaving_corner_.assign(mesh.points.size(), none);
    arriving_corner_.assign(mesh.points.size(), none);
    expected_.assign(mesh.points.size(), 0);
  }

  void check(Index v) {
    if (corners_.row(v).empty()) {
      found_.add("Vertex " + name(v) + " belongs to no face.", none, v, mesh_.points[v]);
      return;
    }
    enter_corners(v);
    check_boundary(v);
    check_walls(v);
    check_fans(v);
    leave_corners(v);
  }

 private:
  void enter_corners(Index v) {
    const auto row = corners_.row(v);
    for (Index i = 0; i < static_cast<Index>(row.size()); ++i) {
      if (leaving_corner_[row[i].next] != none)
        report(v, "Edge " + name(v, row[i].next) + " is used twice in the same direction.",
               row[i].face);
      leaving_corner_[row[i].next] = i;
      arriving_corner_[row[i].prev] = i;
    }
  }

  void leave_corners(Index v) {
    for (const Corner& corner : corners_.row(v))
      leaving_corner_[corner.next] = arriving_corner_[corner.prev] = none;
  }

  /// Boundary half-edges that arrive at v against the expected ones.
  void check_boundary(Index v) {
    for (const DirectedEdge& edge : arriving_.row(v)) {
      if (expected_[edge[0]])
        report(v, "Expected boundary edge " + name(edge[0], v) + " is listed twice.");
      expected_[edge[0]] = 1;
      if (arriving_corner_[edge[0]] == none)
        report(v, "Boundary edge " + name(edge[0], v) + " is missing from the mesh.");
      else if (leaving_corner_[edge[0]] != none)
        report(v, "Boundary edge " + name(edge[0], v) + " has faces on both sides.");
    }
    for (const Corner& corner : corners_.row(v))
      if (leaving_corner_[corner.prev] == none && !expected_[corner.prev])
        report(v, "Edge " + name(corner.prev, v) + " has one face but is not on the boundary.",
               corner.face);
    for (const DirectedEdge& edge : arriving_.row(v)) expected_[edge[0]] = 0;
  }

  void check_walls(Index v) {
    for (const DirectedEdge& wall : walls_.row(v))
      if (leaving_corner_[wall[1]] == none || arriving_corner_[wall[1]] == none)
        report(v, "Wall " + name(v, wall[1]) + " is not an inner edge of the mesh.");
  }

  /// Corners linked across shared edges form chains (one per boundary edge leaving v) or cycles.
  void check_fans(Index v) {
    const auto row = corners_.row(v);
    visited_.assign(row.size(), 0);
    std::size_t fans = 0;
    const auto walk = [&](Index start) {
      ++fans;
      for (Index i = start; i != none && !visited_[i]; i = leaving_corner_[row[i].prev])
        visited_[i] = 1;
    };
    for (Index i = 0; i < static_cast<Index>(row.size()); ++i)
      if (arriving_corner_[row[i].next] == none) walk(i);
    for (Index i = 0; i < static_cast<Index>(row.size()); ++i)
      if (!visited_[i]) walk(i);
    if (fans > std::max<std::size_t>(1, arriving_.row(v).size()))
      report(v, "The faces around vertex " + name(v) + " do not form one fan.");
  }

  void report(Index v, std::string what, Index face = none) {
    found_.add(std::move(what), face, v, mesh_.points[v]);
  }

  const QuadMesh& mesh_;
  Findings& found_;
  Csr<Corner> corners_;
  Csr<DirectedEdge> arriving_, walls_;
  std::vector<Index> leaving_corner_;   // by neighbour: corner at v whose next it is
  std::vector<Index> arriving_corner_;  // by neighbour: corner at v whose prev it is
  std::vector<char> expected_, visited_;
};

std::uint64_t position_hash(Vec2 p) {
  const double value[2] = {p.x + 0.0, p.y + 0.0};  // + 0.0 makes -0 and 0 the same
  std::uint64_t bits[2];
  std::memcpy(bits, value, sizeof bits);
  std::uint64_t h = bits[0] * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29) ^ bits[1]) * 0xBF58476D1CE4E5B9u;
  return h ^ (h >> 32);
}

/// Vertices in buckets by a hash of their position: equal positions share a bucket.
void check_coincident(const QuadMesh& mesh, Findings& found) {
  const auto count = static_cast<Index>(mesh.points.size());
  std::vector<Index> vertices(mesh.points.size());
  for (Index v = 0; v < count; ++v) vertices[v] = v;
  const Csr<Index> buckets = group_by<Index>(count, vertices, [&](Index v) {
    return static_cast<Index>(position_hash(mesh.points[v]) % static_cast<std::uint64_t>(count));
  });
  for (Index b = 0; b < count && !found.full(); ++b) {
    const auto row = buckets.row(b);
    for (std::size_t i = 0; i < row.size() && !found.full(); ++i)
      for (std::size_t j = 0; j < i && !found.full(); ++j)
        if (mesh.points[row[i]] == mesh.points[row[j]])
          found.add("Vertices " + name(row[j]) + " and " + name(row[i]) + " coincide.", none,
                    row[i], mesh.points[row[i]]);
  }
}

void check_vertices(const QuadMesh& mesh, const ExpectedBoundary& boundary, Findings& found) {
  VertexChecker checker(mesh, boundary, found);
  for (Index v = 0; v < static_cast<Index>(mesh.points.size()) && !found.full(); ++v)
    checker.check(v);
}

}  // namespace

std::vector<Violation> validate(const QuadMesh& mesh, const ExpectedBoundary& boundary,
                                std::size_t limit) {
  Findings found(limit);
  check_numbers(mesh, boundary, found);
  if (!found.empty()) return found.take();
  check_given_points(mesh, boundary.points, found);
  check_corners(mesh, found);
  check_coincident(mesh, found);
  check_vertices(mesh, boundary, found);
  return found.take();
}

}  // namespace lpq

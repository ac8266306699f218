// See crossings.h.
#include "shell/crossings.h"

#include <algorithm>
#include <cmath>

#include "base/sort_numbers.h"
#include "shell/place.h"
#include "shell/space_tree.h"
#include "shell/topology.h"

namespace lpq {
namespace {

// Of the side of the smaller face: what goes less deep only touches. Coordinates that a file rounds
// are off by far less, walls thinner than a mesh can follow go deeper.
constexpr double least_depth = 1e-3;
// Over the longer of two sides: the normal of a triangle that is not as high may be anything.
constexpr double least_height = 1e-4;
constexpr std::size_t most_crossings = 10'000;  // that are counted
// Of the size, and of the side of the smaller face where that is less: bodies that go less deep
// into each other fit. Facets of a round thing and of its hole cross at small angles only.
constexpr double fitting_depth = 0.1, fitting_share = 0.15;

/// Half a quad, or a triangle.
struct Corners {
  std::array<Vec3, 3> at;
  Vec3 normal;      // of length 1
  double side = 0;  // of the square that it is half of
};

/// The triangles on both sides of a face's diagonal (0 or 1) that are high enough, `made`.
int halves(std::span<const Vec3> points, const Face& face, int diagonal, Corners (&made)[2]) {
  const int n = corner_count(face);
  int count = 0;
  for (int k = diagonal; k < diagonal + 2 * (n - 2); k += 2) {
    const Vec3 a = points[face[k % n]], b = points[face[(k + 1) % n]];
    const Vec3 c = points[face[(k + 2) % n]];
    const Vec3 ab = b - a, ac = c - a, normal = cross(ab, ac);
    const double area = length(normal);
    if (area > least_height * std::max(squared_length(ab), squared_length(ac)))
      made[count++] = {{a, b, c}, (1 / area) * normal, std::sqrt(area)};
  }
  return count;
}

/// Where the sides of s go through the plane of t, two points; false if s is not deep on both sides
/// of it.
bool cut(const Corners& s, const Corners& t, double depth, Vec3 (&ends)[2]) {
  double height[3], low = 0, high = 0;
  for (int k = 0; k < 3; ++k) {
    height[k] = dot(t.normal, s.at[k] - t.at[0]);
    low = std::min(low, height[k]);
    high = std::max(high, height[k]);
  }
  if (!(low < -depth && high > depth)) return false;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if ((height[k] > 0) == (height[next] > 0)) continue;
    ends[count++] = s.at[k] + height[k] / (height[k] - height[next]) * (s.at[next] - s.at[k]);
  }
  return true;
}

/// Both cut the line where their planes meet: do they share some of it? `fit`: what may be so deep
/// as long as it is not for its side.
bool go_through(const Corners& s, const Corners& t, double fit, Vec3& at) {
  const double side = std::min(s.side, t.side);
  const double depth = std::max(least_depth * side, std::min(fit, fitting_share * side));
  Vec3 of_s[2], of_t[2];
  if (!cut(s, t, depth, of_s) || !cut(t, s, depth, of_t)) return false;
  const Vec3 line = of_s[1] - of_s[0];
  const double whole = squared_length(line);
  const double a = dot(line, of_t[0] - of_s[0]) / whole, b = dot(line, of_t[1] - of_s[0]) / whole;
  const double from = std::max(0.0, std::min(a, b)), to = std::min(1.0, std::max(a, b));
  at = of_s[0] + 0.5 * (from + to) * line;
  return (to - from) * std::sqrt(whole) > depth;
}

/// With these diagonals.
bool go_through(std::span<const Vec3> points, const Face& f, int diagonal_of_f, const Face& g,
                int diagonal_of_g, double fit, Vec3& at) {
  Corners s[2], t[2];
  const int m = halves(points, f, diagonal_of_f, s), n = halves(points, g, diagonal_of_g, t);
  for (int k = 0; k < m; ++k)
    for (int l = 0; l < n; ++l)
      if (go_through(s[k], t[l], fit, at)) return true;
  return false;
}

/// Whichever diagonals they have: how a quad bends between its corners is open.
bool go_through(std::span<const Vec3> points, const Face& f, const Face& g, double fit, Vec3& at) {
  for (const Index v : f)
    if (v != none && std::find(g.begin(), g.end(), v) != g.end()) return false;
  for (int i = 0; i < corner_count(f) - 2; ++i)
    for (int j = 0; j < corner_count(g) - 2; ++j)
      if (!go_through(points, f, i, g, j, fit, at)) return false;
  return true;
}

Box3 box_of(std::span<const Vec3> points, const Face& face) {
  return box_of(points, std::span(face).first(corner_count(face)));
}

/// Faces by what is near.
class NearFaces {
 public:
  NearFaces(std::span<const Vec3> points, std::span<const Face> faces)
      : boxes_(boxes_of(points, faces)), tree_(boxes_, centres_of(boxes_)) {}

  const Box3& box(Index f) const { return boxes_[f]; }

  /// Numbers from `first` of the boxes that overlap this one, ascending.
  void find(const Box3& box, Index first, std::vector<Index>& found) const {
    found.clear();
    Index waiting[SpaceTree::most_waiting];
    int height = 0;
    waiting[height++] = tree_.root();
    while (height > 0) {
      const SpaceTree::Node& node = tree_.node(waiting[--height]);
      if (!overlap(node.box, box)) continue;
      if (node.left != none) {
        waiting[height++] = node.right;
        waiting[height++] = node.left;
        continue;
      }
      for (const Index g : tree_.items(node))
        if (g >= first && overlap(boxes_[g], box)) found.push_back(g);
    }
    sort_numbers(found, [](Index i, Index j) { return i < j; });
  }

 private:
  static std::vector<Box3> boxes_of(std::span<const Vec3> points, std::span<const Face> faces) {
    std::vector<Box3> boxes;
    for (const Face& face : faces) boxes.push_back(box_of(points, face));
    return boxes;
  }
  static std::vector<Vec3> centres_of(std::span<const Box3> boxes) {
    std::vector<Vec3> centres;
    for (const Box3& box : boxes) centres.push_back(midpoint(box.lo, box.hi));
    return centres;
  }

  std::vector<Box3> boxes_;  // #F
  SpaceTree tree_;
};

/// Calls visit(f, g) for the pairs of faces whose boxes overlap, ascending, until it says false.
template <class Visit>
void for_near_pairs(std::span<const Vec3> points, std::span<const Face> faces, Visit visit) {
  if (faces.empty()) return;
  const NearFaces near(points, faces);
  std::vector<Index> later;
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    near.find(near.box(f), f + 1, later);
    for (const Index g : later)
      if (!visit(f, g)) return;
  }
}

/// Where a surface goes through itself.
class GivenNear {
 public:
  explicit GivenNear(const SurfaceMesh& surface)
      : surface_(surface),
        triangles_(faces_of(surface.triangles)),
        near_(surface.points, triangles_),
        crosses_none_(triangles_.size(), 0) {}

  /// Do both triangles of a pair reach into the box?
  bool reaches(const Box3& box) {
    near_.find(box, 0, inside_);
    return std::any_of(inside_.begin(), inside_.end(),
                       [&](Index f) { return !crosses_none_[f] && crosses_later(f, box); });
  }

 private:
  /// One with a greater number that is in the box?
  bool crosses_later(Index f, const Box3& box) {
    bool crosses_none = true;
    near_.find(near_.box(f), f + 1, later_);
    for (const Index g : later_) {
      if (!go_through(f, g)) continue;
      if (overlap(near_.box(g), box)) return true;
      crosses_none = false;
    }
    crosses_none_[f] = crosses_none;
    return false;
  }

  bool go_through(Index f, Index g) const {
    Vec3 at;
    return surface_.body_of(triangles_[f][0]) == surface_.body_of(triangles_[g][0]) &&
           lpq::go_through(surface_.points, triangles_[f], triangles_[g], 0, at);
  }

  const SurfaceMesh& surface_;
  std::vector<Face> triangles_;
  NearFaces near_;
  std::vector<char> crosses_none_;  // #T  with a greater number, as far as is known
  std::vector<Index> inside_, later_;
};

}  // namespace

std::vector<FaceCrossing> find_crossings(std::span<const Vec3> points, std::span<const Face> faces,
                                         std::span<const Index> body, std::size_t limit) {
  std::vector<FaceCrossing> crossings;
  Vec3 at;
  for_near_pairs(points, faces, [&](Index f, Index g) {
    if (!body.empty() && body[faces[f][0]] != body[faces[g][0]]) return true;
    if (go_through(points, faces[f], faces[g], 0, at)) crossings.push_back({{f, g}, at});
    return crossings.size() != limit;
  });
  return crossings;
}

GivenCrossings given_crossings(const SurfaceMesh& surface, std::span<const double> size) {
  GivenCrossings given;
  const std::vector<Face> triangles = faces_of(surface.triangles);
  Vec3 at;
  for_near_pairs(surface.points, triangles, [&](Index f, Index g) {
    const Index v = triangles[f][0], w = triangles[g][0];
    const bool same = surface.body_of(v) == surface.body_of(w);
    std::vector<FaceCrossing>& list = same ? given.within : given.between;
    if (list.size() == most_crossings) return true;
    const double fit = same ? 0 : fitting_depth * std::min(size[v], size[w]);
    if (go_through(surface.points, triangles[f], triangles[g], fit, at))
      list.push_back({{f, g}, at, true});
    return true;
  });
  return given;
}

std::vector<FaceCrossing> mesh_crossings(const SurfaceMesh& surface, const ShellMesh& mesh) {
  std::vector<FaceCrossing> crossings =
      find_crossings(mesh.points, mesh.faces, bodies_at(surface, mesh.places), most_crossings);
  if (crossings.empty()) return crossings;
  GivenNear given(surface);
  for (FaceCrossing& crossing : crossings) {
    Box3 box;
    for (const Index f : crossing.faces) extend(box, box_of(mesh.points, mesh.faces[f]));
    crossing.given = given.reaches(box);
  }
  return crossings;
}

}  // namespace lpq

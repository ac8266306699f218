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

/// Numbers after f of the boxes that overlap that of f, ascending.
void find_later(const SpaceTree& tree, std::span<const Box3> boxes, Index f,
                std::vector<Index>& found) {
  found.clear();
  Index waiting[SpaceTree::most_waiting];
  int height = 0;
  waiting[height++] = tree.root();
  while (height > 0) {
    const SpaceTree::Node& node = tree.node(waiting[--height]);
    if (!overlap(node.box, boxes[f])) continue;
    if (node.left != none) {
      waiting[height++] = node.right;
      waiting[height++] = node.left;
      continue;
    }
    for (const Index g : tree.items(node))
      if (g > f && overlap(boxes[g], boxes[f])) found.push_back(g);
  }
  sort_numbers(found, [](Index i, Index j) { return i < j; });
}

/// Calls visit(f, g) for the pairs of faces whose boxes overlap, ascending, until it says false.
template <class Visit>
void for_near_pairs(std::span<const Vec3> points, std::span<const Face> faces, Visit visit) {
  if (faces.empty()) return;
  std::vector<Box3> boxes;
  std::vector<Vec3> centres;
  for (const Face& face : faces) {
    boxes.push_back(box_of(points, face));
    centres.push_back(midpoint(boxes.back().lo, boxes.back().hi));
  }
  const SpaceTree tree(boxes, centres);
  std::vector<Index> later;
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    find_later(tree, boxes, f, later);
    for (const Index g : later)
      if (!visit(f, g)) return;
  }
}

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
  const std::vector<Face> triangles = faces_of(surface.triangles);
  for (const FaceCrossing& given :
       find_crossings(surface.points, triangles, surface.body, most_crossings)) {
    const auto [s, t] = given.faces;
    const Box3 of_s = box_of(surface.points, triangles[s]);
    const Box3 of_t = box_of(surface.points, triangles[t]);
    for (FaceCrossing& crossing : crossings) {
      Box3 box;
      for (const Index f : crossing.faces) extend(box, box_of(mesh.points, mesh.faces[f]));
      if (overlap(box, of_s) && overlap(box, of_t)) crossing.given = true;
    }
  }
  return crossings;
}

}  // namespace lpq

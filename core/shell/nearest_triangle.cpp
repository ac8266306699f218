// See nearest_triangle.h.
#include "shell/nearest_triangle.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/segment.h"

namespace lpq {
namespace {

Vec3 nearest_on_edge(Vec3 p, Vec3 a, Vec3 b) { return a + share_along(p, a, b) * (b - a); }

SpaceTree tree_over(std::span<const Vec3> points, std::span<const Tri> triangles) {
  std::vector<Box3> boxes;
  std::vector<Vec3> centres;
  for (const Tri& triangle : triangles) {
    const auto [a, b, c] = triangle;
    boxes.push_back(box_of(points, triangle));
    centres.push_back((1.0 / 3) * (points[a] + points[b] + points[c]));
  }
  return {boxes, centres};
}

}  // namespace

// Inside, where p's foot on the plane has three positive weights; else on one of the edges.
Vec3 nearest_in_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 normal = cross(b - a, c - a);
  const double wa = dot(cross(c - b, p - b), normal), wb = dot(cross(a - c, p - c), normal);
  const double wc = dot(cross(b - a, p - a), normal);
  const double sum = wa + wb + wc;
  if (wa > 0 && wb > 0 && wc > 0) return a + (wb / sum) * (b - a) + (wc / sum) * (c - a);
  Vec3 nearest = nearest_on_edge(p, a, b);
  for (const Vec3 other : {nearest_on_edge(p, b, c), nearest_on_edge(p, c, a)})
    if (squared_length(other - p) < squared_length(nearest - p)) nearest = other;
  return nearest;
}

NearestTriangle::NearestTriangle(std::span<const Vec3> points, std::span<const Tri> triangles)
    : points_(points), triangles_(triangles), tree_(tree_over(points, triangles)) {}

void NearestTriangle::look_at(Vec3 p, Index triangle, Hit& best) const {
  const auto [a, b, c] = triangles_[triangle];
  const Vec3 point = nearest_in_triangle(p, points_[a], points_[b], points_[c]);
  const double found = squared_length(point - p);
  if (found < best.squared_distance || (found == best.squared_distance && triangle < best.triangle))
    best = {triangle, point, found};
}

NearestTriangle::Hit NearestTriangle::find(Vec3 p, Index hint) const {
  Hit best{none, {}, std::numeric_limits<double>::infinity()};
  look_at(p, hint, best);
  Index stack[SpaceTree::most_waiting];
  int height = 0;
  stack[height++] = tree_.root();
  while (height > 0) {
    const SpaceTree::Node& node = tree_.node(stack[--height]);
    if (squared_distance(node.box, p) > best.squared_distance) continue;
    if (node.left == none) {
      for (const Index t : tree_.items(node)) look_at(p, t, best);
      continue;
    }
    const double left = squared_distance(tree_.node(node.left).box, p);
    const double right = squared_distance(tree_.node(node.right).box, p);
    stack[height++] = left < right ? node.right : node.left;
    stack[height++] = left < right ? node.left : node.right;  // looked at first
  }
  return best;
}

double NearestTriangle::distance(Vec3 p, Index& hint) const {
  const Hit hit = find(p, hint);
  hint = hit.triangle;
  return std::sqrt(hit.squared_distance);
}

}  // namespace lpq

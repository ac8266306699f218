// See nearest_triangle.h.
#include "shell/nearest_triangle.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/check.h"

namespace lpq {
namespace {

constexpr Index leaf_size = 4;

Vec3 nearest_on_edge(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double whole = squared_length(along);
  if (!(whole > 0)) return a;
  return a + std::clamp(dot(p - a, along) / whole, 0.0, 1.0) * along;
}

double coordinate(Vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

int longest_axis(Vec3 extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

double squared_distance(const Box3& box, Vec3 p) {
  return squared_length({std::max({0.0, box.lo.x - p.x, p.x - box.hi.x}),
                         std::max({0.0, box.lo.y - p.y, p.y - box.hi.y}),
                         std::max({0.0, box.lo.z - p.z, p.z - box.hi.z})});
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
    : points_(points), triangles_(triangles) {
  LPQ_ASSERT(!triangles.empty());
  for (const auto& [a, b, c] : triangles)
    centre_.push_back((1.0 / 3) * (points[a] + points[b] + points[c]));
  order_.resize(triangles.size());
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<Index>(order_.size()));
  centre_ = {};
}

Index NearestTriangle::build(Index first, Index last) {
  Node node{box_of(first, last), first, last - first, none, none};
  if (node.count > leaf_size) {
    const int axis = longest_axis(node.box.hi - node.box.lo);
    const Index middle = first + node.count / 2;
    // With a total order the halves are the same wherever this runs.
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](Index s, Index t) {
                       const double x = coordinate(centre_[s], axis);
                       const double y = coordinate(centre_[t], axis);
                       return x < y || (x == y && s < t);
                     });
    node.left = build(first, middle);
    node.right = build(middle, last);
  }
  nodes_.push_back(node);
  return static_cast<Index>(nodes_.size()) - 1;
}

Box3 NearestTriangle::box_of(Index first, Index last) const {
  Box3 box;
  for (Index i = first; i < last; ++i)
    for (const Index v : triangles_[order_[i]]) extend(box, points_[v]);
  return box;
}

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
  Index stack[64];  // halves: one waiting node per level
  int height = 0;
  stack[height++] = static_cast<Index>(nodes_.size()) - 1;
  while (height > 0) {
    const Node& node = nodes_[stack[--height]];
    if (squared_distance(node.box, p) > best.squared_distance) continue;
    if (node.left == none) {
      for (Index i = node.first; i < node.first + node.count; ++i) look_at(p, order_[i], best);
      continue;
    }
    const double left = squared_distance(nodes_[node.left].box, p);
    const double right = squared_distance(nodes_[node.right].box, p);
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

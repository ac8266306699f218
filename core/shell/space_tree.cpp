// See space_tree.h.
#include "shell/space_tree.h"

#include <cstdint>
#include <numeric>
#include <utility>

#include "base/check.h"

namespace lpq {
namespace {

constexpr Index leaf_size = 4;

double coordinate(Vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

int longest_axis(Vec3 extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

/// Puts numbers that come before the one which belongs in place `middle` before it, and the others
/// behind: Hoare's selection, in O(n) mostly. std::nth_element is 3 KB more of WebAssembly.
template <class Before>
void part(std::span<Index> numbers, Index middle, Before before) {
  std::uint32_t random = 1;
  Index left = 0, right = static_cast<Index>(numbers.size()) - 1;
  while (left < right) {
    random = 1664525 * random + 1013904223;
    const auto count = static_cast<std::uint32_t>(right - left + 1);
    const Index pivot = numbers[left + static_cast<Index>((random >> 8) % count)];
    Index i = left, j = right;
    while (i <= j) {
      while (before(numbers[i], pivot)) ++i;
      while (before(pivot, numbers[j])) --j;
      if (i <= j) std::swap(numbers[i++], numbers[j--]);
    }
    if (middle > j && middle < i) return;
    (middle <= j ? right : left) = middle <= j ? j : i;
  }
}

}  // namespace

Box3 box_of(std::span<const Vec3> points, std::span<const Index> corners) {
  Box3 box;
  for (const Index v : corners) extend(box, points[v]);
  return box;
}

SpaceTree::SpaceTree(std::span<const Box3> boxes, std::span<const Vec3> centres)
    : order_(boxes.size()) {
  LPQ_ASSERT(!boxes.empty());
  std::iota(order_.begin(), order_.end(), 0);
  build(boxes, centres, 0, static_cast<Index>(order_.size()));
}

Index SpaceTree::build(std::span<const Box3> boxes, std::span<const Vec3> centres, Index first,
                       Index last) {
  Node node{{}, first, last - first, none, none};
  for (Index i = first; i < last; ++i) extend(node.box, boxes[order_[i]]);
  if (node.count > leaf_size) {
    const int axis = longest_axis(node.box.hi - node.box.lo);
    const Index middle = first + node.count / 2;
    // With a total order the halves are the same wherever this runs.
    part(std::span(order_).subspan(first, node.count), middle - first, [&](Index s, Index t) {
      const double x = coordinate(centres[s], axis), y = coordinate(centres[t], axis);
      return x < y || (x == y && s < t);
    });
    node.left = build(boxes, centres, first, middle);
    node.right = build(boxes, centres, middle, last);
  }
  nodes_.push_back(node);
  return root();
}

}  // namespace lpq

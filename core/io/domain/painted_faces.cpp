// A walk through the tree of faces that carries along what each group of united outlines paints.
#include <algorithm>
#include <utility>

#include "base/csr.h"
#include "io/domain/painted.h"

namespace lpq {
namespace {

/// What united outlines paint, as their borders say: which ones, and whether this face.
struct Paint {
  Index by = none;  // none: an outline of its own
  bool inside = true;
};

/// Faces are to the left of their walks. What has the paint to its right is what it leaves out, if
/// all edges say so; else a neighbour, with edges of its own.
Paint paint_of(const LineWork& lines, const Walk& face) {
  Paint paint;
  bool all_outside = true;
  for (std::size_t i = 0; i < face.edges.size(); ++i) {
    const LineWork::Edge& edge = lines.edges[face.edges[i]];
    const bool left = edge.painted != none && edge.a == face.points[i];
    if (left) return {edge.painted, true};
    all_outside = all_outside && edge.painted != none;
    paint = {edge.painted, false};
  }
  return all_outside ? paint : Paint{};
}

/// Of each face, and of the outside in the last row: the faces directly in it.
Csr<Index> faces_within(const LoopTree& tree) {
  const auto count = static_cast<Index>(tree.parent.size());
  return csr_from<Index>(tree.parent.size() + 1, [&](auto&& emit) {
    for (Index f = 0; f < count; ++f) emit(tree.parent[f] == none ? count : tree.parent[f], f);
  });
}

}  // namespace

std::vector<char> painted_faces(const LineWork& lines, const NestedFaces& nested) {
  const auto count = static_cast<Index>(nested.planar.faces.size());
  std::vector<Paint> paint;
  Index groups = 0;
  for (const Walk& face : nested.planar.faces) {
    paint.push_back(paint_of(lines, face));
    groups = std::max(groups, paint.back().by + 1);
  }
  const Csr<Index> within = faces_within(nested.tree);
  std::vector<char> filled(count + 1, 0), before(count, 0), is_done(count, 0);
  std::vector<char> here(groups, 0);  // whether the group paints where the walk through the tree is
  std::vector<Index> left(within.row(count).begin(), within.row(count).end());
  while (!left.empty()) {
    const Index f = left.back(), parent = nested.tree.parent[f];
    const auto [by, inside] = paint[f];
    if (std::exchange(is_done[f], 1)) {  // and all in it
      if (by != none) here[by] = before[f];
      left.pop_back();
      continue;
    }
    if (by != none) before[f] = std::exchange(here[by], inside);
    const bool changes = inside != (before[f] != 0);
    filled[f] = changes != (filled[parent == none ? count : parent] != 0);
    left.insert(left.end(), within.row(f).begin(), within.row(f).end());
  }
  filled.pop_back();
  return filled;
}

}  // namespace lpq

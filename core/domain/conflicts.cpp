#include "domain/conflicts.h"

#include "domain/box_tree.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

bool in_conflict(std::span<const Vec2> points, const Segment& s, const Segment& t) {
  const bool aa = s.a == t.a, ab = s.a == t.b, ba = s.b == t.a, bb = s.b == t.b;
  if (!aa && !ab && !ba && !bb)
    return meet(points[s.a], points[s.b], points[t.a], points[t.b]) != Meeting::apart;
  if ((aa && bb) || (ab && ba)) return true;
  const Vec2 from = points[aa || ab ? s.a : s.b];
  const Vec2 p = points[aa || ab ? s.b : s.a], q = points[aa || ba ? t.b : t.a];
  return orient2d(from, p, q) == 0 && (p < from) == (q < from);
}

}  // namespace

std::vector<Index> meeting_edges(std::span<const Vec2> points, std::span<const Segment> edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Segment& e : edges) boxes.push_back(box_of(points[e.a], points[e.b]));
  const BoxTree tree(boxes);
  std::vector<Index> found;
  for (Index i = 0; i < static_cast<Index>(edges.size()); ++i) {
    bool meets = false;
    tree.walk(
        [&](Index, const Box& box) { return !meets && overlap(box, boxes[i]); },
        [&](Index j) { meets = meets || (j != i && in_conflict(points, edges[i], edges[j])); });
    if (meets) found.push_back(i);
  }
  return found;
}

}  // namespace lpq

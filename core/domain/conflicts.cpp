#include "domain/conflicts.h"

#include "domain/edge_pairs.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

bool in_conflict(std::span<const Vec2> points, const Segment& s, const Segment& t) {
  const bool aa = s.a == t.a, ab = s.a == t.b, ba = s.b == t.a, bb = s.b == t.b;
  if (!aa && !ab && !ba && !bb)
    return meet(points[s.a], points[s.b], points[t.a], points[t.b]) != Meeting::apart;
  if ((aa && bb) || (ab && ba)) return true;
  const Vec2 from = points[aa || ab ? s.a : s.b];
  return same_direction(from, points[aa || ab ? s.b : s.a], points[aa || ba ? t.b : t.a]);
}

}  // namespace

std::vector<Index> meeting_edges(std::span<const Vec2> points, std::span<const Segment> edges) {
  std::vector<EdgePairs::Ends> ends;
  ends.reserve(edges.size());
  for (const Segment& e : edges) ends.push_back({e.a, e.b});
  const EdgePairs pairs(points, std::move(ends));
  std::vector<Index> found;
  for (Index i = 0; i < static_cast<Index>(edges.size()); ++i) {
    bool meets = false;
    pairs.each_near(
        i, [&](Index j) { meets = meets || (j != i && in_conflict(points, edges[i], edges[j])); });
    if (meets) found.push_back(i);
  }
  return found;
}

}  // namespace lpq

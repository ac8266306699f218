// Loops that do not cross are nested or apart, so one corner decides for the whole loop, provided
// it does not lie on the other loop: even-odd count along a ray to the left [O'Rourke 1998, 7.4].
#include "domain/nesting.h"

#include <algorithm>

#include "base/sort_numbers.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

/// The loops of the corner's region, other than its own, that contain the corner.
std::vector<Index> loops_around(const Outline& outline, const BoxTree& tree, Index corner,
                                Index own) {
  const Vec2 q = outline.points[corner];
  const Index region = outline.chains[own].region;
  std::vector<Index> hits;
  tree.walk(
      [q](Index, const Box& box) { return box.lo.x <= q.x && box.lo.y <= q.y && q.y <= box.hi.y; },
      [&](Index e) {
        const Edge& edge = outline.edges[e];
        if (edge.chain == own || outline.chains[edge.chain].region != region) return;
        const Vec2 a = outline.points[edge.a], b = outline.points[edge.b];
        if ((a.y > q.y) == (b.y > q.y)) return;
        if ((b.y > a.y) == (orient2d(a, b, q) < 0)) hits.push_back(edge.chain);
      });
  std::sort(hits.begin(), hits.end());
  std::vector<Index> around;
  for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
    while (j < hits.size() && hits[j] == hits[i]) ++j;
    if ((j - i) % 2 == 1) around.push_back(hits[i]);
  }
  return around;
}

/// A corner that lies on no other loop, or none.
Index free_corner(const Chain& chain, const Meetings& meetings) {
  for (Index c = chain.begin; c < chain.end; ++c)
    if (!meetings.on_neighbour[c]) return c;
  return none;
}

/// The corners' vertices from the smallest on, in the direction of the smaller neighbour: equal for
/// two loops exactly if they are the same polygon.
std::vector<Index> fingerprint(const Outline& outline, const Chain& chain) {
  std::vector<Index> v(outline.vertex.begin() + chain.begin, outline.vertex.begin() + chain.end);
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  if (v.size() > 2 && v.back() < v[1]) std::reverse(v.begin() + 1, v.end());
  return v;
}

Error outside(const Outline& outline, const Chain& hole, const Chain& outer, Index corner) {
  Where where = at_point(where_loop(hole), outline.given[corner]);
  where.other_loop = outer.number;
  return {ErrorCode::hole_outside,
          "The hole, " + loop_name(outline, hole) + ", lies outside the outer loop, " +
              loop_name(outline, outer) + ", at " + point_text(outline.given[corner]) +
              ". Give separate pieces as separate regions.",
          where};
}

Error nested(const Outline& outline, const Chain& hole, const Chain& other, Index corner,
             const char* how) {
  Where where = at_point(where_loop(hole), outline.given[corner]);
  where.other_loop = other.number;
  return {ErrorCode::nested_or_duplicate_hole,
          "The hole, " + loop_name(outline, hole) + ", " + how + " another hole, " +
              loop_name(outline, other) + ", at " + point_text(outline.given[corner]) +
              ". Remove one, or give an island as a region of its own.",
          where};
}

/// Holes all of whose corners lie on neighbours: they can still be told when they are equal.
Problem find_duplicate(const Outline& outline, const LoopRoles& roles,
                       const std::vector<Index>& contact_holes) {
  std::vector<std::pair<std::vector<Index>, Index>> prints;
  for (const Index l : contact_holes)
    prints.push_back({fingerprint(outline, outline.chains[l]), l});
  sort_values(prints);
  for (std::size_t i = 1; i < prints.size(); ++i) {
    const Chain &one = outline.chains[prints[i - 1].second],
                &two = outline.chains[prints[i].second];
    if (prints[i - 1].first != prints[i].first || one.region != two.region) continue;
    if (roles.outer[one.region] == prints[i - 1].second) continue;
    return nested(outline, two, one, two.begin, "is the same as");
  }
  return {};
}

}  // namespace

Problem judge_nesting(const Outline& outline, const LoopRoles& roles, const BoxTree& tree,
                      const Meetings& meetings) {
  Problem inside_hole;
  std::vector<Index> contact_holes;
  for (Index l = 0; l < outline.loop_count; ++l) {
    const Chain& hole = outline.chains[l];
    const Index outer = roles.outer[hole.region];
    if (l == outer) continue;
    const Index corner = free_corner(hole, meetings);
    if (corner == none) {
      contact_holes.push_back(l);
      continue;
    }
    const std::vector<Index> around = loops_around(outline, tree, corner, l);
    if (!std::binary_search(around.begin(), around.end(), outer))
      return outside(outline, hole, outline.chains[outer], corner);
    for (const Index other : around)
      if (other != outer && !inside_hole)
        inside_hole = nested(outline, hole, outline.chains[other], corner, "lies inside");
  }
  if (inside_hole) return inside_hole;
  return find_duplicate(outline, roles, contact_holes);
}

}  // namespace lpq

// Loops that do not cross are nested or apart, so one corner decides for the whole loop, provided
// it does not lie on the other loop: even-odd count along a ray to the left [O'Rourke 1998, 7.4].
#include "domain/nesting.h"

#include <algorithm>

#include "base/sort_numbers.h"
#include "domain/box_tree.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

/// The loops of one region, chains begin .. end-1, and rays through them.
class RegionRays {
 public:
  RegionRays(const Outline& outline, Index begin, Index end);
  /// The loops, other than its own, that contain the corner.
  std::vector<Index> loops_around(Index corner, Index own) const;

 private:
  const Outline& outline_;
  Index first_edge_;
  BoxTree tree_;               // of the edges
  std::vector<double> reach_;  // #nodes  how far to the right the loops of its edges go
};

RegionRays::RegionRays(const Outline& outline, Index begin, Index end)
    : outline_(outline), first_edge_(outline.chains[begin].edge_begin) {
  std::vector<Box> boxes;
  std::vector<double> reach;
  for (Index l = begin; l < end; ++l) {
    const Chain& loop = outline.chains[l];
    for (Index e = loop.edge_begin; e < loop.edge_end; ++e)
      boxes.push_back(
          box_of(outline.points[outline.edges[e].a], outline.points[outline.edges[e].b]));
    reach.resize(boxes.size(), box_of(outline.corners(loop)).hi.x);
  }
  tree_ = BoxTree(boxes);
  reach_ = tree_.summarise<double>(reach, [](double x, double y) { return std::max(x, y); });
}

// A loop that ends to the left of the corner is not followed: an even number of hits is none.
std::vector<Index> RegionRays::loops_around(Index corner, Index own) const {
  const Vec2 q = outline_.points[corner];
  std::vector<Index> hits;
  tree_.walk(
      [&](Index node, const Box& box) {
        return box.lo.x <= q.x && q.x <= reach_[node] && box.lo.y <= q.y && q.y <= box.hi.y;
      },
      [&](Index e) {
        const Edge& edge = outline_.edges[first_edge_ + e];
        if (edge.chain == own) return;
        const Vec2 a = outline_.points[edge.a], b = outline_.points[edge.b];
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

class NestingJudge {
 public:
  NestingJudge(const Outline& outline, const LoopRoles& roles, const Meetings& meetings)
      : outline_(outline), roles_(roles), meetings_(meetings) {}

  Problem run() {
    const std::vector<Chain>& chains = outline_.chains;
    for (Index begin = 0, end = 0; begin < outline_.loop_count; begin = end) {
      while (end < outline_.loop_count && chains[end].region == chains[begin].region) ++end;
      if (end - begin < 2) continue;
      const RegionRays rays(outline_, begin, end);
      for (Index l = begin; l < end; ++l)
        if (Problem problem = judge_hole(rays, l)) return problem;
    }
    if (inside_hole_) return inside_hole_;
    return find_duplicate(outline_, roles_, contact_holes_);
  }

 private:
  Problem judge_hole(const RegionRays& rays, Index l) {
    const Chain& hole = outline_.chains[l];
    const Index outer = roles_.outer[hole.region];
    if (l == outer) return {};
    const Index corner = free_corner(hole, meetings_);
    if (corner == none) {
      contact_holes_.push_back(l);
      return {};
    }
    const std::vector<Index> around = rays.loops_around(corner, l);
    if (!std::binary_search(around.begin(), around.end(), outer))
      return outside(outline_, hole, outline_.chains[outer], corner);
    for (const Index other : around)
      if (other != outer && !inside_hole_)
        inside_hole_ = nested(outline_, hole, outline_.chains[other], corner, "lies inside");
    return {};
  }

  const Outline& outline_;
  const LoopRoles& roles_;
  const Meetings& meetings_;
  Problem inside_hole_;  // the first; told only if no hole lies outside
  std::vector<Index> contact_holes_;
};

}  // namespace

Problem judge_nesting(const Outline& outline, const LoopRoles& roles, const Meetings& meetings) {
  return NestingJudge(outline, roles, meetings).run();
}

}  // namespace lpq

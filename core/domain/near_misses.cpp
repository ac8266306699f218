#include "domain/near_misses.h"

#include <algorithm>

#include "base/few_warnings.h"
#include "base/sort_numbers.h"
#include "base/words.h"
#include "domain/box_tree.h"
#include "domain/edge_pairs.h"
#include "domain/outline.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

// In the unit frame. Below about a thousand steps between doubles no shape is left to quads.
constexpr double no_room = 1e-13;
// Gaps that people mean, of motors and of cracks, are wider than this.
constexpr double widest_hair = 1e-5;
constexpr double lengths_to_gap = 100;  // of what runs along each other

struct Approach {
  double gap;
  Vec2 at, other_at;  // on either wall
};

class NearMisses {
 public:
  explicit NearMisses(Domain& domain)
      : domain_(domain), ends_(ends_of(domain)), pairs_(domain.points, ends_) {
    sort_values(ends_);
  }
  Problem judge();

 private:
  using Ends = EdgePairs::Ends;

  static std::vector<Ends> ends_of(const Domain& domain);
  std::vector<Index> near(Index i) const;
  Problem compare(Index i, Index j);
  Problem judge_points();
  Problem judge_point(Index v, const BoxTree& tree) const;
  Approach approach(const Segment& s, const Segment& t) const;
  bool run_along(const Segment& s, const Segment& t, double gap) const;
  Index facing(const Segment& s, Vec2 q) const;
  bool are_joined(const Segment& s, const Segment& t) const;
  std::string name(const Segment& s) const;
  std::string apart(double gap) const;
  Where where(const Segment& s, Vec2 at) const;
  Vec2 at(Index v) const { return domain_.points[v]; }

  Domain& domain_;
  std::vector<Ends> ends_;  // of the segments, the smaller first; sorted
  EdgePairs pairs_;
  FewWarnings warnings_;
};

std::vector<NearMisses::Ends> NearMisses::ends_of(const Domain& domain) {
  std::vector<Ends> ends;
  ends.reserve(domain.segments.size());
  for (const Segment& s : domain.segments) ends.push_back({std::min(s.a, s.b), std::max(s.a, s.b)});
  return ends;
}

/// By a common end, or a segment between their ends: around a short one its neighbours come near.
bool NearMisses::are_joined(const Segment& s, const Segment& t) const {
  for (const Index v : {s.a, s.b})
    for (const Index w : {t.a, t.b})
      if (v == w ||
          std::binary_search(ends_.begin(), ends_.end(), Ends{std::min(v, w), std::max(v, w)}))
        return true;
  return false;
}

/// Later segments that segment i may run along.
std::vector<Index> NearMisses::near(Index i) const {
  const Segment& s = domain_.segments[i];
  const double along = distance(at(s.a), at(s.b)) / lengths_to_gap;
  std::vector<Index> found;
  pairs_.each_near(
      i,
      [&](Index j) {
        if (j > i) found.push_back(j);
      },
      std::max(no_room, std::min(widest_hair, along)));
  return found;
}

// They do not meet, so that one of the two points is an end.
Approach NearMisses::approach(const Segment& s, const Segment& t) const {
  Approach best{distance(at(s.a), closest_point(at(s.a), at(t.a), at(t.b))), at(s.a),
                closest_point(at(s.a), at(t.a), at(t.b))};
  const auto take = [&](Vec2 p, Vec2 q) {
    if (const double gap = distance(p, q); gap < best.gap) best = {gap, p, q};
  };
  take(at(s.b), closest_point(at(s.b), at(t.a), at(t.b)));
  for (const Index v : {t.a, t.b}) take(closest_point(at(v), at(s.a), at(s.b)), at(v));
  return best;
}

/// The region of s that q lies in sight of; `none` is the outside, and what is on its line.
Index NearMisses::facing(const Segment& s, Vec2 q) const {
  const int side = orient2d(at(s.a), at(s.b), q);
  return side == 0 ? none : side < 0 ? s.right : s.left;
}

/// For a piece of many gaps' length, where the gap stays about what it is.
bool NearMisses::run_along(const Segment& s, const Segment& t, double gap) const {
  const Vec2 along = (1 / distance(at(s.a), at(s.b))) * (at(s.b) - at(s.a));
  const double p = dot(at(t.a) - at(s.a), along), q = dot(at(t.b) - at(s.a), along);
  const double from = std::max(0.0, std::min(p, q));
  const double to = std::min(distance(at(s.a), at(s.b)), std::max(p, q));
  if (!(to - from >= lengths_to_gap * gap)) return false;
  for (const double place : {from, to}) {
    const Vec2 here = at(s.a) + place * along;
    if (distance(here, closest_point(here, at(t.a), at(t.b))) > widest_hair) return false;
  }
  return true;
}

std::string NearMisses::name(const Segment& s) const {
  std::string text = "edge " + std::to_string(s.edge);
  if (s.region == none) return text + " of polyline " + std::to_string(s.loop);
  text += " of loop " + std::to_string(s.loop);
  if (domain_.regions.size() < 2) return text;
  text += " of region " + std::to_string(s.region);
  const std::string& region = domain_.regions[s.region];
  return region.empty() ? text : text + " (" + region + ")";
}

std::string NearMisses::apart(double gap) const {
  return short_number(domain_.frame.length_to_world(gap));
}

Where NearMisses::where(const Segment& s, Vec2 place) const {
  const Vec2 world = domain_.frame.to_world(place);
  Where where = at_point({}, world);
  where.region = s.region;
  where.loop = s.region == none ? none : s.loop;
  where.edge = s.edge;
  return where;
}

Problem NearMisses::compare(Index i, Index j) {
  const Segment &s = domain_.segments[i], &t = domain_.segments[j];
  const auto [gap, p, q] = approach(s, t);
  if (gap > widest_hair || are_joined(s, t)) return {};
  const Index inside = facing(s, q);
  if (gap < no_room && inside != none && facing(t, p) == inside)
    return Error{ErrorCode::touching,
                 "Between " + name(s) + " and " + name(t) + " only " + apart(gap) +
                     " is left, which is rounding. Let them share the edge, or move one of them.",
                 where(s, p)};
  const bool two_regions = s.region != none && t.region != none && s.region != t.region;
  const bool across_nothing = inside == none && facing(t, p) == none;
  if (!two_regions || !across_nothing || !run_along(s, t, gap)) return {};
  warnings_.add({ErrorCode::touching,
                 "Along " + name(s) + " and " + name(t) + " two regions are only " + apart(gap) +
                     " apart, and not joined. If they are to be joined, give both edges the same "
                     "two points.",
                 where(s, p)});
  return {};
}

Problem NearMisses::judge_point(Index v, const BoxTree& tree) const {
  Index wall = none;
  tree.walk(
      [&](Index, const Box& box) {
        return squared_distance(box, Box{at(v), at(v)}) <= no_room * no_room;
      },
      [&](Index i) {
        const Segment& s = domain_.segments[i];
        const Vec2 q = closest_point(at(v), at(s.a), at(s.b));
        if (distance(at(v), q) < no_room && (wall == none || i < wall)) wall = i;
      });
  if (wall == none) return {};
  return Error{ErrorCode::touching,
               "The point " + point_text(domain_.given[v]) + " all but lies on " +
                   name(domain_.segments[wall]) + ". Make it a corner there, or move it.",
               where(domain_.segments[wall], at(v))};
}

Problem NearMisses::judge_points() {
  std::vector<char> on_segment(domain_.points.size(), 0);
  for (const Segment& s : domain_.segments) on_segment[s.a] = on_segment[s.b] = 1;
  if (std::find(on_segment.begin(), on_segment.end(), 0) == on_segment.end()) return {};
  std::vector<Box> boxes;
  for (const Segment& s : domain_.segments) boxes.push_back(box_of(at(s.a), at(s.b)));
  const BoxTree tree(boxes);
  for (Index v = 0; v < static_cast<Index>(domain_.points.size()); ++v)
    if (!on_segment[v])
      if (Problem problem = judge_point(v, tree)) return problem;
  return {};
}

Problem NearMisses::judge() {
  for (Index i = 0; i < static_cast<Index>(domain_.segments.size()); ++i)
    for (const Index j : near(i))
      if (Problem problem = compare(i, j)) return problem;
  if (Problem problem = judge_points()) return problem;
  for (Warning& warning : warnings_.take()) domain_.warnings.push_back(std::move(warning));
  return {};
}

}  // namespace

Problem judge_near_misses(Domain& domain) { return NearMisses(domain).judge(); }

}  // namespace lpq

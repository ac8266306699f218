// Around a vertex, the left side of a segment and the right side of the next one counter-clockwise
// are the same sector. Around a connected component of segments lies one face, which the first
// segment to the left of the component's smallest point borders, too.
#include "domain/parts.h"

#include <algorithm>

#include "base/check.h"
#include "base/csr.h"
#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"
#include "domain/box_tree.h"
#include "domain/directions.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

// Sides are numbered 2 s for the left of segment s, 2 s + 1 for its right.
Index left_of(Index segment) { return 2 * segment; }
Index right_of(Index segment) { return 2 * segment + 1; }

bool is_polyline(const Segment& segment) { return segment.region == none; }

class PartFinder {
 public:
  PartFinder(std::span<const Vec2> points, std::span<const Segment> segments)
      : points_(points),
        segments_(segments),
        sides_(2 * static_cast<Index>(segments.size())),
        component_(static_cast<Index>(points.size())) {}
  Parts run();

 private:
  // One end of a segment, seen from its vertex.
  struct Spoke {
    Index far;
    Index left, right;  // sides
  };

  void build_fans();
  void join_sectors(Index vertex);
  void join_components();
  Index side_to_the_left(Vec2 q) const;
  bool is_nearer(Index s, Index t) const;
  Vec2 lower(Index s) const { return is_up(s) ? at(segments_[s].a) : at(segments_[s].b); }
  Vec2 upper(Index s) const { return is_up(s) ? at(segments_[s].b) : at(segments_[s].a); }
  bool is_up(Index s) const { return at(segments_[s].b).y > at(segments_[s].a).y; }
  Vec2 at(Index point) const { return points_[point]; }

  std::span<const Vec2> points_;
  std::span<const Segment> segments_;
  Csr<Spoke> fans_;
  DisjointSets sides_;      // of one part
  DisjointSets component_;  // #P  points joined by segments
  BoxTree tree_;
};

void PartFinder::build_fans() {
  fill_csr(fans_, points_.size(), [&](auto&& emit) {
    for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i) {
      const Segment& s = segments_[i];
      emit(s.a, Spoke{s.b, left_of(i), right_of(i)});
      emit(s.b, Spoke{s.a, right_of(i), left_of(i)});
    }
  });
  for (const Segment& s : segments_) component_.unite(s.a, s.b);
}

void PartFinder::join_sectors(Index vertex) {
  const auto row = fans_.row(vertex);
  std::vector<Spoke> fan(row.begin(), row.end());
  const Counterclockwise before{at(vertex)};
  sort_values(fan, [&](const Spoke& s, const Spoke& t) { return before(at(s.far), at(t.far)); });
  for (std::size_t i = 0; i < fan.size(); ++i)
    sides_.unite(fan[i].left, fan[(i + 1) % fan.size()].right);
}

/// Of two segments that do not cross and both pass q at its left, at q's height: whether s is the
/// one nearer to q.
bool PartFinder::is_nearer(Index s, Index t) const {
  // Where one ends, the other still is: its end tells, unless it lies on the other.
  const Vec2 end = upper(s).y <= upper(t).y ? upper(s) : upper(t);
  const bool own = end == upper(s);
  const int by_upper = own ? orient2d(lower(t), upper(t), end) : -orient2d(lower(s), upper(s), end);
  if (by_upper != 0) return by_upper < 0;
  if (lower(s).y >= lower(t).y) return orient2d(lower(t), upper(t), lower(s)) < 0;
  return orient2d(lower(s), upper(s), lower(t)) > 0;
}

/// The side, facing q, of the first segment to the left of q; none if there is none.
Index PartFinder::side_to_the_left(Vec2 q) const {
  Index nearest = none;
  tree_.walk(
      [q](Index, const Box& box) { return box.lo.x <= q.x && box.lo.y <= q.y && q.y <= box.hi.y; },
      [&](Index i) {
        const Vec2 a = at(segments_[i].a), b = at(segments_[i].b);
        if ((a.y > q.y) == (b.y > q.y)) return;
        if ((b.y > a.y) != (orient2d(a, b, q) < 0)) return;
        if (nearest == none || is_nearer(i, nearest)) nearest = i;
      });
  if (nearest == none) return none;
  return is_up(nearest) ? right_of(nearest) : left_of(nearest);
}

// The smallest point of a component looks to the left into the sector after its last spoke: all its
// spokes lie in the half-plane to the right.
void PartFinder::join_components() {
  std::vector<Index> smallest(points_.size(), none);
  for (Index v = 0; v < static_cast<Index>(points_.size()); ++v) {
    Index& known = smallest[component_.root(v)];
    if (known == none || at(v) < at(known)) known = v;
  }
  std::vector<Box> boxes;
  for (const Segment& s : segments_) boxes.push_back(box_of(at(s.a), at(s.b)));
  tree_ = BoxTree(boxes);
  for (const Index v : smallest) {
    if (v == none || fans_.row(v).empty()) continue;
    const auto fan = fans_.row(v);
    const Spoke* last = &fan[0];
    for (const Spoke& spoke : fan)
      if (orient2d(at(v), at(last->far), at(spoke.far)) > 0) last = &spoke;
    const Index beyond = side_to_the_left(at(v));
    if (beyond != none) sides_.unite(last->left, beyond);
  }
}

Parts PartFinder::run() {
  build_fans();
  for (Index v = 0; v < static_cast<Index>(points_.size()); ++v)
    if (!fans_.row(v).empty()) join_sectors(v);
  join_components();
  Parts parts;
  parts.segments.assign(segments_.begin(), segments_.end());
  std::vector<Index> number(2 * segments_.size(), none);
  const auto part_at = [&](Index side, Index region) {
    if (region == none) return none;
    Index& part = number[sides_.root(side)];
    if (part == none) {
      part = parts.count();
      parts.region.push_back(region);
    }
    LPQ_ASSERT(parts.region[part] == region);
    return part;
  };
  for (Index i = 0; i < static_cast<Index>(segments_.size()); ++i) {
    Segment& s = parts.segments[i];
    s.left = part_at(left_of(i), s.left);
    s.right = part_at(right_of(i), s.right);
  }
  return parts;
}

Parts whole_regions(std::span<const Segment> segments) {
  Parts parts;
  parts.segments.assign(segments.begin(), segments.end());
  for (const Segment& s : segments)
    for (const Index side : {s.left, s.right})
      while (side >= parts.count()) parts.region.push_back(parts.count());
  return parts;
}

}  // namespace

Parts find_parts(std::span<const Vec2> points, std::span<const Segment> segments) {
  if (std::none_of(segments.begin(), segments.end(), is_polyline)) return whole_regions(segments);
  return PartFinder(points, segments).run();
}

}  // namespace lpq

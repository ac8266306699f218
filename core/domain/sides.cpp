// Around a vertex, the left side of a segment and the right side of the next one counter-clockwise
// are the same sector, so they must name the same region. Around a connected component of segments
// lies one face, whose region a ray from the component's smallest point tells: no other component
// touches this one, so no count along the ray is in doubt.
#include "domain/sides.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/csr.h"
#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"
#include "domain/box_tree.h"
#include "domain/directions.h"
#include "domain/outline.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

constexpr Index unknown = -2;

bool is_polyline(const Segment& segment) { return segment.region == none; }

class SideSettler {
 public:
  explicit SideSettler(Domain& domain)
      : domain_(domain), component_(static_cast<Index>(domain.points.size())) {}
  Problem run();

 private:
  // One end of a segment, seen from its vertex.
  struct Spoke {
    Index segment;
    Index far;
    Index left, right;
  };

  void build_fans();
  void build_tree();
  void sort_fan(Index vertex, std::span<Spoke> fan) const;
  Problem settle_fan(Index vertex);
  void give_polyline(Index segment, Index region);
  Problem settle_components();
  std::vector<char> vertices_on_loops() const;
  DisjointSets joined_polylines(const std::vector<char>& on_loop) const;
  Problem settle_polylines();
  Problem settle_points();
  Index region_at(Index vertex, Problem& problem);
  Vec2 at(Index point) const { return domain_.points[point]; }
  std::string name(Index region) const;
  Index claimant(Index region, Index segment, Index other) const;
  Error conflict(Index vertex, Index one, Index two) const;
  Error outside(const std::string& what, Vec2 world) const;

  Domain& domain_;
  BoxTree tree_;
  std::vector<double> reach_;  // #nodes of it  how far to the right the components below go
  Csr<Spoke> fans_;
  DisjointSets component_;
  std::vector<Index> smallest_;  // #P  of the component with this root
};

std::string SideSettler::name(Index region) const {
  if (region == none) return "the outside";
  const std::string& text = domain_.regions[region];
  return "region " + std::to_string(region) + (text.empty() ? "" : " (" + text + ")");
}

/// Who says that a region is beside a segment: where it is the outside, the region inside of it.
Index SideSettler::claimant(Index region, Index segment, Index other) const {
  const Index inside = domain_.segments[segment].region;
  return region == none && inside != other ? inside : region;
}

Error SideSettler::conflict(Index vertex, Index one, Index two) const {
  const Vec2 world = domain_.given[vertex];
  Where where = at_point({}, world);
  where.region = one == none ? two : one;
  return {ErrorCode::region_conflict,
          "Two regions overlap at " + point_text(world) + ": " + name(one) + " and " + name(two) +
              " claim the same place. Regions may share edges and corners only; give a region that "
              "lies within another a hole in the outer one.",
          where};
}

Error SideSettler::outside(const std::string& what, Vec2 world) const {
  return {ErrorCode::hole_outside,
          what + " lies outside the domain at " + point_text(world) +
              ". Only what lies inside can become part of the mesh.",
          at_point({}, world)};
}

void SideSettler::build_fans() {
  fill_csr(fans_, domain_.points.size(), [&](auto&& emit) {
    for (Index i = 0; i < static_cast<Index>(domain_.segments.size()); ++i) {
      const Segment& s = domain_.segments[i];
      const Index l = is_polyline(s) ? unknown : s.left, r = is_polyline(s) ? unknown : s.right;
      emit(s.a, Spoke{i, s.b, l, r});
      emit(s.b, Spoke{i, s.a, r, l});
    }
  });
  for (const Segment& s : domain_.segments) component_.unite(s.a, s.b);
}

// What ends to the left of a point does not contain it: rays to the left leave it out.
void SideSettler::build_tree() {
  std::vector<Box> boxes;
  std::vector<double> of_component(domain_.points.size(), -HUGE_VAL), reach;
  for (const Segment& s : domain_.segments) {
    boxes.push_back(box_of(at(s.a), at(s.b)));
    double& right = of_component[component_.root(s.a)];
    right = std::max(right, boxes.back().hi.x);
  }
  for (const Segment& s : domain_.segments) reach.push_back(of_component[component_.root(s.a)]);
  tree_ = BoxTree(boxes);
  reach_ = tree_.summarise<double>(reach, [](double x, double y) { return std::max(x, y); });
}

void SideSettler::sort_fan(Index vertex, std::span<Spoke> fan) const {
  const Counterclockwise before{at(vertex)};
  std::vector<Spoke> sorted(fan.begin(), fan.end());
  // No two spokes have the same direction: they would overlap.
  sort_values(sorted, [&](const Spoke& s, const Spoke& t) { return before(at(s.far), at(t.far)); });
  std::copy(sorted.begin(), sorted.end(), fan.begin());
}

Problem SideSettler::settle_fan(Index vertex) {
  const auto fan = fans_.row(vertex);
  sort_fan(vertex, fan);
  Index start = 0;
  while (start < static_cast<Index>(fan.size()) && fan[start].left == unknown) ++start;
  if (start == static_cast<Index>(fan.size())) return {};  // polylines only
  Index sector = fan[start].left, before = fan[start].segment;
  for (std::size_t i = 1; i <= fan.size(); ++i) {
    const Spoke& spoke = fan[(start + i) % fan.size()];
    if (spoke.right == unknown) {
      give_polyline(spoke.segment, sector);
      continue;
    }
    if (spoke.right != sector)
      return conflict(vertex, claimant(sector, before, spoke.right),
                      claimant(spoke.right, spoke.segment, sector));
    sector = spoke.left;
    before = spoke.segment;
  }
  return {};
}

void SideSettler::give_polyline(Index segment, Index region) {
  Segment& s = domain_.segments[segment];
  s.left = s.right = region;
}

/// The region around a vertex as told by the segments of other components.
Index SideSettler::region_at(Index vertex, Problem& problem) {
  const Vec2 q = at(vertex);
  const Index own = component_.root(vertex);
  std::vector<Index> sides;
  tree_.walk(
      [&](Index node, const Box& box) {
        return box.lo.x <= q.x && q.x <= reach_[node] && box.lo.y <= q.y && q.y <= box.hi.y;
      },
      [&](Index i) {
        const Segment& s = domain_.segments[i];
        if (is_polyline(s) || component_.root(s.a) == own) return;
        const Vec2 a = at(s.a), b = at(s.b);
        if ((a.y > q.y) == (b.y > q.y)) return;
        if ((b.y > a.y) != (orient2d(a, b, q) < 0)) return;
        for (const Index side : {s.left, s.right})
          if (side != none) sides.push_back(side);
      });
  std::sort(sides.begin(), sides.end());
  Index region = none;
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j] == sides[i]) ++j;
    if ((j - i) % 2 == 0) continue;
    if (region != none && !problem) problem = conflict(vertex, region, sides[i]);
    region = sides[i];
  }
  return region;
}

// The smallest point of a component looks to the left into the sector after its last spoke: all its
// spokes lie in the half-plane to the right.
Problem SideSettler::settle_components() {
  for (Index v = 0; v < static_cast<Index>(domain_.points.size()); ++v) {
    if (smallest_[component_.root(v)] != v) continue;
    auto fan = fans_.row(v);
    const Spoke* last = nullptr;
    for (const Spoke& spoke : fan)
      if (spoke.left != unknown &&
          (last == nullptr || orient2d(at(v), at(last->far), at(spoke.far)) > 0))
        last = &spoke;
    if (last == nullptr) continue;
    Problem problem;
    const Index around = region_at(v, problem);
    if (problem) return problem;
    if (around != last->left)
      return conflict(v, around, claimant(last->left, last->segment, around));
  }
  return {};
}

std::vector<char> SideSettler::vertices_on_loops() const {
  std::vector<char> on_loop(domain_.points.size(), 0);
  for (const Segment& s : domain_.segments)
    if (!is_polyline(s)) on_loop[s.a] = on_loop[s.b] = 1;
  return on_loop;
}

// Segments of polylines that are joined to each other, but not through a vertex of a loop.
DisjointSets SideSettler::joined_polylines(const std::vector<char>& on_loop) const {
  const Index count = static_cast<Index>(domain_.segments.size());
  DisjointSets joined(count);
  std::vector<Index> at_vertex(domain_.points.size(), none);
  for (Index i = 0; i < count; ++i) {
    const Segment& s = domain_.segments[i];
    if (!is_polyline(s)) continue;
    for (const Index v : {s.a, s.b}) {
      if (on_loop[v]) continue;
      if (at_vertex[v] == none) at_vertex[v] = i;
      joined.unite(i, at_vertex[v]);
    }
  }
  return joined;
}

// Joined polylines share a region: that of the sector where they meet a loop, else what lies around
// them.
Problem SideSettler::settle_polylines() {
  const std::vector<char> on_loop = vertices_on_loops();
  DisjointSets joined = joined_polylines(on_loop);
  const Index count = static_cast<Index>(domain_.segments.size());
  std::vector<Index> region(count, unknown);
  for (Index i = 0; i < count; ++i) {
    const Segment& s = domain_.segments[i];
    if (is_polyline(s) && (on_loop[s.a] || on_loop[s.b])) region[joined.root(i)] = s.left;
  }
  for (Index i = 0; i < count; ++i) {
    Segment& s = domain_.segments[i];
    if (!is_polyline(s)) continue;
    Index& shared = region[joined.root(i)];
    Problem problem;
    if (shared == unknown) shared = region_at(s.a, problem);
    if (problem) return problem;
    if (shared == none) {
      Error error =
          outside("Edge " + std::to_string(s.edge) + " of polyline " + std::to_string(s.loop),
                  domain_.given[s.a]);
      error.where.edge = s.edge;
      return error;
    }
    s.left = s.right = shared;
  }
  return {};
}

Problem SideSettler::settle_points() {
  for (Index v = 0; v < static_cast<Index>(domain_.points.size()); ++v) {
    if (!fans_.row(v).empty()) continue;
    const Vec2 p = at(v);
    Index carrier = none;
    tree_.walk(
        [p](Index, const Box& box) {
          return overlap(box, Box{p, p});
        },
        [&](Index i) {
          const Segment& s = domain_.segments[i];
          if (on_segment(p, at(s.a), at(s.b))) carrier = i;
        });
    const Vec2 world = domain_.given[v];
    if (carrier != none) {
      const Segment& s = domain_.segments[carrier];
      Where where = at_point({}, world);
      where.region = s.region;
      where.loop = is_polyline(s) ? none : s.loop;
      where.edge = s.edge;
      return Error{ErrorCode::touching,
                   "The point " + point_text(world) + " lies on edge " + std::to_string(s.edge) +
                       " of " + (is_polyline(s) ? "polyline " : "loop ") + std::to_string(s.loop) +
                       ". Make it a " +
                       (is_polyline(s) ? "point of that polyline" : "corner of that edge's loop") +
                       " instead.",
                   where};
    }
    Problem problem;
    if (region_at(v, problem) == none && !problem) problem = outside("A point", world);
    if (problem) return problem;
  }
  return {};
}

Problem SideSettler::run() {
  build_fans();
  const Index n = static_cast<Index>(domain_.points.size());
  smallest_.assign(n, none);
  for (Index v = 0; v < n; ++v) {
    Index& smallest = smallest_[component_.root(v)];
    if (smallest == none || at(v) < at(smallest)) smallest = v;
  }
  const bool plain = domain_.regions.size() == 1 && domain_.segments.back().region != none;
  const bool points = fans_.row(n - 1).empty();  // isolated points come last
  if (plain && !points) return {};
  build_tree();
  for (Index v = 0; v < n; ++v)
    if (fans_.row(v).size() > 2)
      if (Problem problem = settle_fan(v)) return problem;
  if (Problem problem = settle_components()) return problem;
  if (Problem problem = settle_polylines()) return problem;
  return settle_points();
}

}  // namespace

Problem settle_sides(Domain& domain) { return SideSettler(domain).run(); }

}  // namespace lpq

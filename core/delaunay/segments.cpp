// Constraint insertion [Anglada 1997]: the triangles that a segment crosses are removed, and the
// two pseudo-polygons left and right of it are triangulated anew: over a base edge stands the
// triangle of the chain vertex whose circle is empty, and so on over its two other edges. The
// result is again a constrained Delaunay triangulation. Chains are kept by half-edges, since a
// vertex may occur twice and an edge may dangle into the cavity. Every chain vertex lies strictly
// left of every base it is considered for (it sees the segment, and sight lines do not cross), so
// circles can be compared without further tests. Cost per segment that crosses k edges: the degree
// of its first end, plus O(k log k) if the chains divide evenly, O(k^2) if they do not.
// Segments come in random order, which keeps the expected sum of the k nearly linear [Agarwal,
// Arge, Yi 2005]; in the order of the boundary it is quadratic for combs. The chains of a comb do
// not divide evenly, so its filling still grows quadratically, with a small constant: 1.2 s for
// 128000 nodes, where 8 edges are crossed but 1900 chain vertices compared per node.
#include <array>
#include <string>
#include <utility>

#include "base/rng.h"
#include "delaunay/whole_plane.h"
#include "geometry/predicates_inline.h"

namespace lpq {
namespace {

// One edge of the cavity's border, from vertex `from` to that of the next link (counter-clockwise
// seen from inside: it is the left chain from a to b, then the right one from b back to a).
struct Link {
  Index from = none;
  Index beyond = none;   // half-edge outside the cavity; none: the edge dangles
  Index partner = none;  // if it dangles: the link of its other side
  Index inside = none;   // if it dangles: the new half-edge inside, once known
  unsigned char wall = 0;
};

// A part of the border still to be filled, between two of its vertices.
struct Gap {
  Index first, last;  // positions in the border
  Index beyond;       // half-edge on the other side of its base, none for the segment itself
};

class SegmentInserter {
 public:
  SegmentInserter(WholePlane& plane, Index fixed)
      : plane_(plane), fixed_(fixed), leaving_(leaving_half_edges(plane)) {
    plane_.wall.assign(plane_.twins.size(), 0);
  }

  bool mark_existing(Index a, Index b) {
    const Index e = find_edge(plane_, leaving_, a, b);
    if (e != none) plane_.wall[e] = plane_.wall[plane_.twins[e]] = 1;
    return e != none;
  }

  Problem insert(Index a, Index b) {
    if (a == b) return touching(a);
    if (mark_existing(a, b)) return std::nullopt;  // a cavity may have been filled with it
    if (auto error = open_cavity(a, b)) return error;
    read_border(a);
    const Index middle = static_cast<Index>(left_.size());
    const Index base = fill({0, middle, none});
    fill({middle, static_cast<Index>(border_.size()) - 1, base});
    LPQ_ASSERT(free_.empty());
    plane_.wall[base] = plane_.wall[plane_.twins[base]] = 1;
    return std::nullopt;
  }

 private:
  int side(Index a, Index b, Index v) const {
    return orient2d_inline(plane_.points[a], plane_.points[b], plane_.points[v]);
  }

  // The half-edge a->r of the triangle (a, r, l) in which the segment leaves a, none if the
  // segment runs into a vertex at once.
  Index first_crossing(Index a, Index b, Index& met) const {
    const Vec2 origin = plane_.points[a], along = plane_.points[b] - origin;
    Index e = leaving_[a];
    const Index stop = e;
    do {
      const Index r = plane_.target(e), l = plane_.apex(e);
      if (r != none) {
        const int side_r = side(a, b, r);
        if (side_r == 0 && dot(plane_.points[r] - origin, along) > 0) {
          met = r;
          return none;
        }
        if (side_r < 0 && l != none && side(a, b, l) > 0) return e;
      }
      e = plane_.rotated(e);
    } while (e != stop);
    LPQ_ASSERT(false);  // the segment lies within the convex hull
    met = a;
    return none;
  }

  // Walks from a to b; collects the crossed triangles and the half-edges inside along both chains.
  Problem open_cavity(Index a, Index b) {
    left_.clear();
    right_.clear();
    Index met = none;
    const Index start = first_crossing(a, b, met);
    if (start == none) return touching(met);
    free_.assign({triangle_of(start)});
    right_.push_back(start);
    left_.push_back(prev_in_triangle(start));
    Index crossed = next_in_triangle(start);
    while (true) {
      if (plane_.wall[crossed]) return crossing(a, b, crossed);
      const Index f = plane_.twins[crossed];  // l -> r
      const Index to_left = prev_in_triangle(f), from_right = next_in_triangle(f);
      const Index d = plane_.apex(f);
      free_.push_back(triangle_of(f));
      const int at_d = d == b ? 0 : side(a, b, d);
      if (at_d == 0 && d != b) return touching(d);
      if (at_d >= 0) left_.push_back(to_left);
      if (at_d <= 0) right_.push_back(from_right);
      if (d == b) return std::nullopt;
      crossed = at_d > 0 ? from_right : to_left;
    }
  }

  // Turns the collected half-edges into links, which stay valid while triangles are reused. An edge
  // whose both sides are inside the cavity is recognised by the mark left on its other side.
  void read_border(Index a) {
    border_.clear();
    const auto mark_of = [](std::size_t link) { return -2 - static_cast<Index>(link); };
    const auto read = [&](Index inside) {
      Link link;
      link.from = plane_.target(inside);
      link.beyond = plane_.twins[inside];
      link.wall = plane_.wall[inside];
      plane_.twins[inside] = mark_of(border_.size());
      border_.push_back(link);
    };
    for (const Index e : left_) read(e);
    for (std::size_t i = right_.size(); i-- > 0;) read(right_[i]);
    for (Link& link : border_) {
      if (const Index mark = plane_.twins[link.beyond]; mark < none) {
        link.partner = -2 - mark;
        link.beyond = none;
      }
    }
    border_.push_back({.from = a});
  }

  // Triangulates a gap; returns the half-edge on its base.
  Index fill(Gap whole) {
    Index base = none;
    gaps_.assign({whole});
    while (!gaps_.empty()) {
      const Gap gap = gaps_.back();
      gaps_.pop_back();
      if (gap.last == gap.first + 1) {
        close(gap.first, gap.beyond);
        continue;
      }
      const Index top = empty_circle_vertex(gap);
      const Index e =
          new_triangle(border_[gap.first].from, border_[gap.last].from, border_[top].from);
      if (base == none) base = e;
      if (gap.beyond != none) plane_.link(e, gap.beyond);
      gaps_.push_back({top, gap.last, e + 1});
      gaps_.push_back({gap.first, top, e + 2});
    }
    return base;
  }

  Index empty_circle_vertex(const Gap& gap) const {
    const auto& p = plane_.points;
    const Index u = border_[gap.first].from, w = border_[gap.last].from;
    Index best = none;
    for (Index i = gap.first + 1; i < gap.last; ++i) {
      const Index v = border_[i].from;
      if (v == u || v == w) continue;  // its other occurrence
      LPQ_ASSERT(side(u, w, v) > 0);
      if (best == none || in_circle_inline(p[u], p[w], p[border_[best].from], p[v]) > 0) best = i;
    }
    LPQ_ASSERT(best != none);
    return best;
  }

  Index new_triangle(Index a, Index b, Index c) {
    LPQ_ASSERT(!free_.empty());
    const Index e = 3 * free_.back();
    free_.pop_back();
    const Tri corners{a, b, c};
    plane_.triangles[triangle_of(e)] = corners;
    for (Index k = 0; k < 3; ++k) {
      plane_.wall[e + k] = 0;
      leaving_[corners[k]] = e + k;
    }
    return e;
  }

  // Joins the new half-edge e to what lies beyond the border's edge.
  void close(Index position, Index e) {
    Link& link = border_[position];
    plane_.wall[e] = link.wall;
    if (link.partner == none) {
      plane_.link(e, link.beyond);
    } else {
      link.inside = e;
      if (const Index other = border_[link.partner].inside; other != none) plane_.link(e, other);
    }
  }

  Error touching(Index v) const {
    Error error;
    const Index number = plane_.given[v];
    if (number < fixed_) {
      error.code = ErrorCode::touching;
      error.message = "Boundary point " + std::to_string(number) +
                      " lies on a boundary edge that does not end there: divide the edge.";
    } else {
      error.code = ErrorCode::hole_outside;
      error.message = "Interior point " + std::to_string(number - fixed_) +
                      " lies on a boundary edge, not strictly inside the domain.";
    }
    error.where.set_point(plane_.points[v].x, plane_.points[v].y);
    return error;
  }

  Error crossing(Index a, Index b, Index e) const {
    const Vec2 p = plane_.points[a], q = plane_.points[b];
    const Vec2 r = plane_.points[plane_.origin(e)], s = plane_.points[plane_.target(e)];
    const double at_r = std::abs(cross(q - p, r - p)), at_s = std::abs(cross(q - p, s - p));
    Error error;
    error.code = ErrorCode::self_intersection;
    error.message = "The boundary edges " + name(a, b) + " and " +
                    name(plane_.origin(e), plane_.target(e)) + " cross.";
    const Vec2 place = r + (at_r + at_s > 0 ? at_r / (at_r + at_s) : 0.5) * (s - r);
    error.where.set_point(place.x, place.y);
    return error;
  }

  std::string name(Index a, Index b) const {
    return std::to_string(plane_.given[a]) + "-" + std::to_string(plane_.given[b]);
  }

  WholePlane& plane_;
  Index fixed_;
  std::vector<Index> leaving_;
  std::vector<Index> left_, right_;  // half-edges inside along the chains, both from a to b
  std::vector<Index> free_;          // triangles of the cavity
  std::vector<Link> border_;
  std::vector<Gap> gaps_;
};

}  // namespace

Index find_edge(const WholePlane& plane, std::span<const Index> leaving, Index a, Index b) {
  Index e = leaving[a];
  const Index stop = e;
  do {
    if (plane.target(e) == b) return e;
    e = plane.rotated(e);
  } while (e != stop);
  return none;
}

Problem insert_segments(WholePlane& plane, std::span<const Segment> segments, Index fixed) {
  const std::vector<Index> vertex = vertex_numbers(plane);
  SegmentInserter inserter(plane, fixed);
  std::vector<std::array<Index, 2>> missing;
  for (const Segment& s : segments) {
    const Index a = vertex[s.a], b = vertex[s.b];
    if (!inserter.mark_existing(a, b)) missing.push_back({a, b});
  }
  Rng rng(missing.size());
  for (std::size_t i = missing.size(); i > 1; --i) {
    std::swap(missing[i - 1], missing[static_cast<std::size_t>(rng.below(i))]);
  }
  for (const auto& [a, b] : missing) {
    if (auto error = inserter.insert(a, b)) return error;
  }
  return std::nullopt;
}

}  // namespace lpq

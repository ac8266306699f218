// See check_outline.h.
#include "cli/check_outline.h"

#include <algorithm>

#include "base/csr.h"
#include "base/disjoint_sets.h"
#include "domain/box_tree.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

using DirectedEdge = std::array<Index, 2>;

/// An edge as seen from one of its ends.
struct Spoke {
  Index end = none;
  bool leaves = false;  // the mesh is to its left, else to its right
};

class OutlineChecker {
 public:
  OutlineChecker(std::span<const Vec2> points, std::span<const DirectedEdge> outline,
                 std::size_t limit)
      : points_(points), outline_(outline), limit_(limit) {
    std::vector<Box> boxes;
    for (const DirectedEdge& edge : outline)
      boxes.push_back(box_of(point(edge[0]), point(edge[1])));
    tree_ = BoxTree(boxes);
    spokes_ = csr_from<Spoke>(points.size(), [&](auto&& emit) {
      for (const DirectedEdge& edge : outline) {
        emit(edge[0], Spoke{edge[1], true});
        emit(edge[1], Spoke{edge[0], false});
      }
    });
  }

  std::vector<Violation> check() {
    for (const DirectedEdge& edge : outline_) check_meetings(edge);
    if (found_.empty())
      for (Index v = 0; v < static_cast<Index>(points_.size()); ++v) check_turn(v);
    if (found_.empty()) check_nesting();
    return std::move(found_);
  }

 private:
  Vec2 point(Index v) const { return points_[static_cast<std::size_t>(v)]; }
  static std::string name(const DirectedEdge& edge) {
    return std::to_string(edge[0]) + "-" + std::to_string(edge[1]);
  }
  void add(std::string what, Index v, Vec2 at) {
    if (found_.size() < limit_) found_.push_back({std::move(what), none, v, at});
  }

  void check_meetings(const DirectedEdge& edge);
  void check_turn(Index v);
  void check_nesting();
  bool turns_rightly(Index v) const;
  int winding_left_of(Index v) const;
  std::vector<Spoke> spokes_in_turn(Index v) const;

  std::span<const Vec2> points_;
  std::span<const DirectedEdge> outline_;
  std::size_t limit_;
  BoxTree tree_;
  Csr<Spoke> spokes_;
  std::vector<Violation> found_;
};

/// Every vertex of the outline is the start of one of its edges, and edges that overlap have an end
/// of one of them in the other.
void OutlineChecker::check_meetings(const DirectedEdge& edge) {
  const Vec2 a = point(edge[0]), b = point(edge[1]);
  const Box box = box_of(a, b);
  tree_.walk([&](Index, const Box& other) { return found_.size() < limit_ && overlap(box, other); },
             [&](Index i) {
               const DirectedEdge& other = outline_[static_cast<std::size_t>(i)];
               const Vec2 c = point(other[0]), d = point(other[1]);
               if (!(c == a) && !(c == b) && on_segment(c, a, b)) {
                 add("Vertex " + std::to_string(other[0]) + " lies on edge " + name(edge) +
                         ", which does not end there: faces do not meet edge to edge.",
                     other[0], c);
               } else if (edge < other && meet(a, b, c, d) == Meeting::crossing) {
                 add("Edges " + name(edge) + " and " + name(other) + " cross: faces overlap.",
                     edge[0], crossing_point(a, b, c, d));
               }
             });
}

/// The edges at v by their angle, from straight down (excluded) counter-clockwise.
std::vector<Spoke> OutlineChecker::spokes_in_turn(Index v) const {
  const auto row = spokes_.row(v);
  std::vector<Spoke> spokes(row.begin(), row.end());
  const Vec2 at = point(v);
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& s, const Spoke& t) {
    const Vec2 p = point(s.end), q = point(t.end);
    const bool left_p = p < at, left_q = q < at;
    return left_p != left_q ? left_q : orient2d(at, p, q) > 0;
  });
  return spokes;
}

/// Going round a vertex, the mesh begins and ends alternately.
void OutlineChecker::check_turn(Index v) {
  if (spokes_.row(v).size() <= 2 || found_.size() >= limit_) return;
  const std::vector<Spoke> spokes = spokes_in_turn(v);
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    if (spokes[i].leaves != spokes[(i + 1) % spokes.size()].leaves) continue;
    return add("Faces overlap at vertex " + std::to_string(v) + ".", v, point(v));
  }
}

/// How many faces lie just left of v, which is the least vertex of its part of the outline: by the
/// edges that a ray to the left crosses, those through vertices counted as if it ran a bit higher.
int OutlineChecker::winding_left_of(Index v) const {
  const Vec2 p = point(v);
  int winding = 0;
  tree_.walk(
      [&](Index, const Box& box) { return box.lo.y <= p.y && p.y <= box.hi.y && box.lo.x <= p.x; },
      [&](Index i) {
        const DirectedEdge& edge = outline_[static_cast<std::size_t>(i)];
        if (edge[0] == v || edge[1] == v) return;
        const Vec2 a = point(edge[0]), b = point(edge[1]);
        const bool upwards = a.y <= p.y && p.y < b.y, downwards = b.y <= p.y && p.y < a.y;
        if (upwards && orient2d(a, b, p) < 0) --winding;
        if (downwards && orient2d(a, b, p) > 0) ++winding;
      });
  return winding;
}

bool OutlineChecker::turns_rightly(Index v) const {
  const int around = winding_left_of(v);
  return around == (spokes_in_turn(v).front().leaves ? 0 : 1);
}

void OutlineChecker::check_nesting() {
  DisjointSets parts(static_cast<Index>(points_.size()));
  for (const DirectedEdge& edge : outline_) parts.unite(edge[0], edge[1]);
  std::vector<Index> least(points_.size(), none);
  for (const DirectedEdge& edge : outline_) {
    Index& first = least[static_cast<std::size_t>(parts.root(edge[0]))];
    if (first == none || point(edge[0]) < point(first)) first = edge[0];
  }
  for (const Index v : least)
    if (v != none && !turns_rightly(v))
      add("The faces at vertex " + std::to_string(v) + " lie on other faces.", v, point(v));
}

}  // namespace

std::vector<Violation> check_own_outline(std::span<const Vec2> points,
                                         std::span<const DirectedEdge> outline, std::size_t limit) {
  return OutlineChecker(points, outline, limit).check();
}

}  // namespace lpq

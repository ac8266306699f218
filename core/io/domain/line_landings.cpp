// See line_landings.h.
#include "io/domain/line_landings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/csr.h"
#include "domain/box_tree.h"
#include "geometry/segment.h"
#include "io/domain/outlines.h"

namespace lpq {
namespace {

class Lander {
 public:
  Lander(LineWork& lines, double tolerance)
      : lines_(lines), tolerance_(tolerance), outline_area_(outline_areas(lines)) {
    std::vector<Box> boxes;
    for (const LineWork::Edge& edge : lines.edges) {
      Box box = box_of(point(edge.a), point(edge.b));
      const double reach = tolerance + std::abs(edge.bow);
      box.lo = box.lo - Vec2{reach, reach};
      box.hi = box.hi + Vec2{reach, reach};
      boxes.push_back(box);
    }
    tree_ = BoxTree(boxes);
    edges_at_ = csr_from<Index>(lines.points.size(), [&](auto&& emit) {
      for (Index e = 0; e < static_cast<Index>(lines.edges.size()); ++e) {
        emit(lines.edges[e].a, e);
        emit(lines.edges[e].b, e);
      }
    });
  }

  Landings run() {
    for (Index i = 0; i < static_cast<Index>(lines_.points.size()); ++i) {
      if (edges_at_.row(i).empty()) continue;
      if (lines_.loose[static_cast<std::size_t>(i)]) {
        land(i);
      } else {
        land_beside(i);
      }
    }
    divide_edges(lines_, std::move(stops_));
    return landings_;
  }

 private:
  Vec2 point(Index i) const { return lines_.points[static_cast<std::size_t>(i)]; }
  Index other_end(Index e, Index i) const {
    const LineWork::Edge& edge = lines_.edges[static_cast<std::size_t>(e)];
    return edge.a == i ? edge.b : edge.a;
  }
  void add_stop(Index e, Index i, double gap) {
    const LineWork::Edge& edge = lines_.edges[static_cast<std::size_t>(e)];
    stops_.push_back({e, dot(point(i) - point(edge.a), point(edge.b) - point(edge.a)), i});
    if (landings_.count++ > 0 && gap <= landings_.farthest) return;
    landings_.farthest = gap;
    landings_.farthest_at = point(i);
  }
  double gap_to(Index e, Index i) const;
  double gap_to_curve(const LineWork::Edge& edge, Vec2 p) const;
  void land(Index i);
  void land_on_copies(Index e, Index i, double gap);
  void land_beside(Index i);
  bool are_beside(const LineWork::Edge& one, const LineWork::Edge& two) const;
  bool runs_along(const LineWork::Edge& edge, Index i, Index j) const;

  LineWork& lines_;
  double tolerance_;
  BoxTree tree_;
  Csr<Index> edges_at_;               // of each point
  std::vector<double> outline_area_;  // twice, signed
  std::vector<Stop> stops_;
  Landings landings_;
};

/// How far point i is from landing on the edge between its ends; infinite if it does not.
double Lander::gap_to(Index e, Index i) const {
  const LineWork::Edge& edge = lines_.edges[static_cast<std::size_t>(e)];
  const Vec2 a = point(edge.a), b = point(edge.b), p = point(i), foot = closest_point(p, a, b);
  const bool exact = on_segment(p, a, b);
  for (const Index f : edges_at_.row(i)) {
    const Index j = other_end(f, i);
    if (j == i) continue;  // an edge whose ends were joined
    if (!exact && (j == edge.a || j == edge.b)) return HUGE_VAL;
    if (exact && meet(a, b, p, point(j)) == Meeting::overlapping) return HUGE_VAL;
  }
  if (exact) return 0;
  return foot == a || foot == b ? HUGE_VAL : std::min(distance(p, foot), gap_to_curve(edge, p));
}

/// From the curve that the edge stands for: what ends exactly on a circle ends beside its chords.
/// A curve that a few corners follow this closely is a parabola over every edge.
double Lander::gap_to_curve(const LineWork::Edge& edge, Vec2 p) const {
  const Vec2 way = point(edge.b) - point(edge.a), from_a = p - point(edge.a);
  const double t = dot(from_a, way) / squared_length(way);
  return std::abs(cross(way, from_a) / length(way) - 4 * edge.bow * t * (1 - t));
}

/// Edges drawn again are divided as well, to stay alike. Beside a curve nothing is to be told: the
/// edges that stand for it are farther from it.
void Lander::land_on_copies(Index e, Index i, double gap) {
  const LineWork::Edge& edge = lines_.edges[static_cast<std::size_t>(e)];
  const Vec2 p = point(i);
  tree_.walk(
      [&](Index, const Box& box) {
        return overlap(box, Box{p, p});
      },
      [&](Index f) {
        const LineWork::Edge& other = lines_.edges[static_cast<std::size_t>(f)];
        if (std::minmax(edge.a, edge.b) == std::minmax(other.a, other.b))
          add_stop(f, i, edge.bow != 0 ? 0 : gap);
      });
}

void Lander::land(Index i) {
  const Vec2 p = point(i);
  Index nearest = none;
  double least = tolerance_;
  tree_.walk(
      [&](Index, const Box& box) {
        return overlap(box, Box{p, p});
      },
      [&](Index e) {
        const LineWork::Edge& edge = lines_.edges[static_cast<std::size_t>(e)];
        if (edge.a == i || edge.b == i) return;
        const double gap = gap_to(e, i);
        if (gap == 0) add_stop(e, i, 0);  // on each of several
        if (gap > least || (gap == least && nearest != none && e > nearest)) return;
        least = gap;
        nearest = e;
      });
  if (nearest != none && least > 0) land_on_copies(nearest, i, least);
}

/// Whether closed outlines along the same line are on either side of it.
bool Lander::are_beside(const LineWork::Edge& one, const LineWork::Edge& two) const {
  const bool same_way = dot(point(one.b) - point(one.a), point(two.b) - point(two.a)) > 0;
  const bool same_turn = (outline_area_[one.outline] > 0) == (outline_area_[two.outline] > 0);
  return same_way != same_turn;
}

/// Whether the way from i, which is beside the edge, to j has a length in common with it.
bool Lander::runs_along(const LineWork::Edge& edge, Index i, Index j) const {
  const Vec2 a = point(edge.a), b = point(edge.b), p = point(i), q = point(j);
  const Vec2 foot = closest_point(q, a, b);  // where both end
  return distance(p, foot) > tolerance_ && distance(foot, closest_point(foot, p, q)) <= tolerance_;
}

/// Corners of closed outlines divide the edges of others that they lie beside, as neighbours do
/// that share a part of a border. Of outlines that overlap or lie in each other nothing is said.
void Lander::land_beside(Index i) {
  const Vec2 p = point(i);
  const auto is_own = [&](Index outline) {
    for (const Index f : edges_at_.row(i))
      if (lines_.edges[f].outline == outline) return true;
    return false;
  };
  const auto land_on = [&](Index e) {
    const LineWork::Edge& edge = lines_.edges[e];
    if (edge.outline == none || edge.bow != 0 || is_own(edge.outline)) return;
    const Vec2 a = point(edge.a), b = point(edge.b);
    const double gap = distance(p, closest_point(p, a, b));
    if (gap > tolerance_ || distance(p, a) <= tolerance_ || distance(p, b) <= tolerance_) return;
    for (const Index f : edges_at_.row(i)) {
      const LineWork::Edge& own = lines_.edges[f];
      if (own.outline == none || own.bow != 0 || !are_beside(own, edge)) continue;
      if (runs_along(edge, i, other_end(f, i))) return add_stop(e, i, gap);
    }
  };
  tree_.walk([&](Index, const Box& box) { return overlap(box, Box{p, p}); }, land_on);
}

}  // namespace

Landings divide_at_landings(LineWork& lines, double tolerance) {
  return Lander(lines, tolerance).run();
}

std::vector<char> points_on_edges(const LineWork& lines, std::span<const Vec2> points) {
  const auto end = [&](Index i) { return lines.points[static_cast<std::size_t>(i)]; };
  std::vector<Box> boxes;
  for (const LineWork::Edge& edge : lines.edges) boxes.push_back(box_of(end(edge.a), end(edge.b)));
  const BoxTree tree(boxes);
  std::vector<char> on_edge;
  for (const Vec2 p : points) {
    bool found = false;
    tree.walk(
        [&](Index, const Box& box) {
          return !found && overlap(box, Box{p, p});
        },
        [&](Index e) {
          const LineWork::Edge& edge = lines.edges[static_cast<std::size_t>(e)];
          found = found || on_segment(p, end(edge.a), end(edge.b));
        });
    on_edge.push_back(found);
  }
  return on_edge;
}

}  // namespace lpq

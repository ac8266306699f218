// See line_landings.h.
#include "io/domain/line_landings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/csr.h"
#include "domain/box_tree.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

class Lander {
 public:
  Lander(LineWork& lines, double tolerance) : lines_(lines), tolerance_(tolerance) {
    std::vector<Box> boxes;
    for (const LineWork::Edge& edge : lines.edges) {
      Box box = box_of(point(edge.a), point(edge.b));
      const double reach = tolerance + std::abs(edge.bow);
      box.lo = box.lo - Vec2{reach, reach};
      box.hi = box.hi + Vec2{reach, reach};
      boxes.push_back(box);
    }
    tree_ = BoxTree(boxes);
    neighbours_ = csr_from<Index>(lines.points.size(), [&](auto&& emit) {
      for (const LineWork::Edge& edge : lines.edges) {
        emit(edge.a, edge.b);
        emit(edge.b, edge.a);
      }
    });
  }

  Landings run() {
    for (Index i = 0; i < static_cast<Index>(lines_.points.size()); ++i)
      if (lines_.loose[static_cast<std::size_t>(i)] && !neighbours_.row(i).empty()) land(i);
    divide_edges(lines_, std::move(stops_));
    return landings_;
  }

 private:
  Vec2 point(Index i) const { return lines_.points[static_cast<std::size_t>(i)]; }
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

  LineWork& lines_;
  double tolerance_;
  BoxTree tree_;
  Csr<Index> neighbours_;
  std::vector<Stop> stops_;
  Landings landings_;
};

/// How far point i is from landing on the edge between its ends; infinite if it does not.
double Lander::gap_to(Index e, Index i) const {
  const LineWork::Edge& edge = lines_.edges[static_cast<std::size_t>(e)];
  const Vec2 a = point(edge.a), b = point(edge.b), p = point(i), foot = closest_point(p, a, b);
  const bool exact = on_segment(p, a, b);
  for (const Index j : neighbours_.row(i)) {
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

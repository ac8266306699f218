// See crossings.h.
#include "io/domain/crossings.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "domain/box_tree.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

constexpr std::size_t most_crossings = 1 << 20;
// A rounded crossing bends its edges, and they may cross others beside it; twice in a row is rare.
constexpr int most_rounds = 8;

/// On the way from a to b, beside both of them.
bool lies_between(Vec2 p, Vec2 a, Vec2 b, double tolerance) {
  return distance(p, closest_point(p, a, b)) <= tolerance && distance(p, a) > tolerance &&
         distance(p, b) > tolerance;
}

bool meet_wrongly(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double tolerance) {
  if (a == b || c == d) return false;
  if (tolerance > 0 && (lies_between(a, c, d, tolerance) || lies_between(b, c, d, tolerance) ||
                        lies_between(c, a, b, tolerance) || lies_between(d, a, b, tolerance)))
    return true;
  const bool common = a == c || a == d || b == c || b == d;
  switch (meet(a, b, c, d)) {
    case Meeting::apart: return false;
    case Meeting::crossing: return true;
    case Meeting::touching: return !common;
    case Meeting::overlapping: return !((a == c && b == d) || (a == d && b == c));
  }
  return false;
}

class Divider {
 public:
  Divider(LineWork& lines, double tolerance) : lines_(lines), tolerance_(tolerance) {}

  void divide(const std::vector<Crossing>& crossings) {
    for (const Crossing& c : crossings) stop_at(c);
    divide_edges(lines_, std::move(stops_));
  }

 private:
  Vec2 at(Index p) const { return lines_.points[p]; }

  void stop_at(const Crossing& c) {
    const LineWork::Edge one = lines_.edges[c.edge], two = lines_.edges[c.other];
    const std::size_t before = stops_.size();
    for (const Index p : {two.a, two.b})
      if (is_on(one, p)) add(c.edge, p);
    for (const Index p : {one.a, one.b})
      if (is_on(two, p)) add(c.other, p);
    if (stops_.size() > before) return;
    const auto point = static_cast<Index>(lines_.points.size());
    lines_.points.push_back(crossing_point(at(one.a), at(one.b), at(two.a), at(two.b)));
    add(c.edge, point);
    add(c.other, point);
  }

  bool is_on(const LineWork::Edge& edge, Index p) const {
    const Vec2 a = at(edge.a), b = at(edge.b);
    return at(p) != a && at(p) != b &&
           (on_segment(at(p), a, b) || lies_between(at(p), a, b, tolerance_));
  }

  void add(Index edge, Index point) {
    const Vec2 a = at(lines_.edges[edge].a), b = at(lines_.edges[edge].b);
    stops_.push_back({edge, dot(at(point) - a, b - a), point});
  }

  LineWork& lines_;
  double tolerance_;
  std::vector<Stop> stops_;
};

/// Points within the tolerance of one to the left of them, or below, go there.
void weld(LineWork& lines, double tolerance) {
  std::vector<Index> order(lines.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index p, Index q) { return lines.points[p] < lines.points[q]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    Vec2& p = lines.points[order[i]];
    for (std::size_t j = i; j-- > 0 && p.x - lines.points[order[j]].x <= tolerance;) {
      if (distance(p, lines.points[order[j]]) > tolerance) continue;
      p = lines.points[order[j]];
      break;
    }
  }
}

void drop_edges_without_length(LineWork& lines) {
  const auto no_length = [](const LineWork::Edge& edge) { return edge.a == edge.b; };
  lines.edges.erase(std::remove_if(lines.edges.begin(), lines.edges.end(), no_length),
                    lines.edges.end());
}

}  // namespace

std::optional<std::vector<Crossing>> find_crossings(const LineWork& lines, double tolerance) {
  const auto at = [&](Index p) { return lines.points[p]; };
  std::vector<Box> boxes;
  boxes.reserve(lines.edges.size());
  for (const LineWork::Edge& edge : lines.edges) boxes.push_back(box_of(at(edge.a), at(edge.b)));
  const BoxTree tree(boxes);
  std::vector<Crossing> crossings;
  for (Index e = 0; e < static_cast<Index>(boxes.size()); ++e) {
    const LineWork::Edge& one = lines.edges[e];
    const Vec2 margin{tolerance, tolerance};
    const Box reach{boxes[e].lo - margin, boxes[e].hi + margin};
    tree.walk([&](Index, const Box& box) { return overlap(reach, box); },
              [&](Index f) {
                const LineWork::Edge& two = lines.edges[f];
                if (f > e && meet_wrongly(at(one.a), at(one.b), at(two.a), at(two.b), tolerance))
                  crossings.push_back({e, f});
              });
    if (crossings.size() > most_crossings) return std::nullopt;
  }
  return crossings;
}

bool divide_at_crossings(LineWork& lines, double tolerance) {
  for (int round = 0; round < most_rounds; ++round) {
    weld(lines, tolerance);
    merge_equal_points(lines);
    drop_edges_without_length(lines);
    const auto crossings = find_crossings(lines, tolerance);
    if (!crossings) return false;
    if (crossings->empty()) return true;
    Divider(lines, tolerance).divide(*crossings);
  }
  return false;
}

}  // namespace lpq

// See line_work.h.
#include "io/domain/line_work.h"

#include <algorithm>
#include <numeric>

#include "base/csr.h"
#include "domain/box_tree.h"
#include "io/domain/line_landings.h"

namespace lpq {
namespace {

// Of the tolerance: what is nearer than this was meant to be at one place, also by closed outlines.
constexpr double rounding_share = 1e-4;

void drop_doubled_edges(LineWork& lines, Joined& joined) {
  std::vector<Index> order(lines.edges.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](Index e) {
    const LineWork::Edge& edge = lines.edges[e];
    return std::minmax(edge.a, edge.b);
  };
  std::stable_sort(order.begin(), order.end(), [&](Index e, Index f) {
    const auto [a, b] = key(e);
    const auto [c, d] = key(f);
    return a != c ? a < c : b < d;
  });
  std::vector<char> dropped(lines.edges.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const LineWork::Edge& edge = lines.edges[order[k]];
    dropped[order[k]] = edge.a == edge.b;
    if (k == 0 || edge.a == edge.b) continue;
    const LineWork::Edge& before = lines.edges[order[k - 1]];
    if (std::minmax(edge.a, edge.b) != std::minmax(before.a, before.b)) continue;
    dropped[order[k]] = 1;
    lines.copies.push_back(edge);
    if (joined.doubled++ == 0) joined.doubled_at = lines.points[edge.a];
  }
  std::size_t kept = 0;
  for (std::size_t e = 0; e < lines.edges.size(); ++e)
    if (!dropped[e]) lines.edges[kept++] = lines.edges[e];
  lines.edges.resize(kept);
}

/// The points that edges join each point to.
Csr<Index> neighbours_of(const LineWork& lines) {
  return csr_from<Index>(lines.points.size(), [&](auto&& emit) {
    for (const LineWork::Edge& edge : lines.edges) {
      emit(edge.a, edge.b);
      emit(edge.b, edge.a);
    }
  });
}

/// The nearest point to point i within the tolerance that is not one of its neighbours, or none.
Index nearest_point(const LineWork& lines, const BoxTree& tree, Index i,
                    std::span<const Index> neighbours, double tolerance) {
  const Vec2 p = lines.points[i];
  double best = tolerance * tolerance;
  Index nearest = none;
  tree.walk(
      [&](Index, const Box& box) {
        return squared_distance(box, Box{p, p}) <= best;
      },
      [&](Index j) {
        const double d = squared_length(lines.points[j] - p);
        if (j == i || d > best || (d == best && nearest != none && j > nearest)) return;
        if (std::find(neighbours.begin(), neighbours.end(), j) != neighbours.end()) return;
        best = d;
        nearest = j;
      });
  return nearest;
}

void move_points(LineWork& lines, double tolerance, Joined& joined) {
  const Csr<Index> neighbours = neighbours_of(lines);
  std::vector<Box> boxes;
  for (const Vec2 p : lines.points) boxes.push_back({p, p});
  const BoxTree tree(boxes);
  std::vector<Index> root(lines.points.size());
  std::iota(root.begin(), root.end(), 0);
  // Closed outlines are not closed further, however small they are.
  std::vector<Index> outline(lines.points.size(), none);
  for (const LineWork::Edge& edge : lines.edges) outline[edge.a] = edge.outline;
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (Index i = 0; i < static_cast<Index>(root.size()); ++i) {
    const double reach = lines.loose[i] ? tolerance : rounding_share * tolerance;
    const Index j = nearest_point(lines, tree, i, neighbours.row(i), reach);
    if (j == none) continue;
    // Loose points move first; of two alike the first one stays.
    const Index u = find(i), v = find(j);
    if (u == v || (!lines.loose[u] && !lines.loose[v] &&
                   (outline[u] == outline[v] ||
                    distance(lines.points[u], lines.points[v]) > rounding_share * tolerance)))
      continue;
    const bool move_u = lines.loose[u] == lines.loose[v] ? v < u : lines.loose[u] != 0;
    root[move_u ? u : v] = move_u ? v : u;
    const double gap = distance(lines.points[i], lines.points[j]);
    if (joined.moved++ > 0 && gap <= joined.farthest) continue;
    joined.farthest = gap;
    joined.moved_at = lines.points[i];
  }
  for (LineWork::Edge& edge : lines.edges) {
    edge.a = find(edge.a);
    edge.b = find(edge.b);
  }
}

}  // namespace

void divide_edges(LineWork& lines, std::vector<Stop> stops) {
  std::sort(stops.begin(), stops.end(), [](const Stop& s, const Stop& t) {
    if (s.edge != t.edge) return s.edge < t.edge;
    return s.way != t.way ? s.way < t.way : s.point < t.point;
  });
  std::vector<LineWork::Edge> edges;
  edges.reserve(lines.edges.size() + stops.size());
  auto stop = stops.begin();
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    LineWork::Edge rest = lines.edges[e];
    for (; stop != stops.end() && stop->edge == static_cast<Index>(e); ++stop) {
      edges.push_back(rest);
      edges.back().b = rest.a = stop->point;
    }
    edges.push_back(rest);
  }
  lines.edges = std::move(edges);
}

// The distinct points keep the order of their first appearance.
void merge_equal_points(LineWork& lines) {
  const std::size_t n = lines.points.size();
  std::vector<Index> order(n), number(n, none);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return lines.points[i] < lines.points[j]; });
  for (std::size_t k = 1; k < n; ++k) {
    const Index before = order[k - 1], i = order[k];
    if (lines.points[before] == lines.points[i])
      number[i] = number[before] == none ? before : number[before];
  }
  Index count = 0;
  lines.loose.resize(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = number[i] == none;  // a first appearance has the least index of its place
    const bool loose = lines.loose[i] != 0;
    number[i] = first ? count++ : number[number[i]];
    lines.points[number[i]] = lines.points[i];
    lines.loose[number[i]] = loose && (first || lines.loose[number[i]]);
  }
  lines.points.resize(static_cast<std::size_t>(count));
  lines.loose.resize(static_cast<std::size_t>(count));
  for (LineWork::Edge& edge : lines.edges) {
    edge.a = number[edge.a];
    edge.b = number[edge.b];
  }
}

void LineWork::add(std::span<const Vec2> polyline, bool closed, Index source,
                   std::span<const double> bows) {
  const auto first = static_cast<Index>(points.size());
  points.insert(points.end(), polyline.begin(), polyline.end());
  loose.resize(points.size(), !closed);
  const auto end = static_cast<Index>(points.size());
  const Index outline = closed ? first : none;  // a number that no other one has
  const auto add_edge = [&](Index a, Index b) {
    const auto k = static_cast<std::size_t>(a - first);
    edges.push_back({a, b, source, none, outline, k < bows.size() ? bows[k] : 0});
  };
  for (Index i = first; i + 1 < end; ++i) add_edge(i, i + 1);
  if (closed && end - first > 2) add_edge(end - 1, first);
}

Joined join_points(LineWork& lines, double tolerance) {
  Joined joined;
  merge_equal_points(lines);
  if (tolerance > 0) {
    move_points(lines, tolerance, joined);
    const Landings landings = divide_at_landings(lines, tolerance);
    joined.landed = landings.count;
    joined.farthest_landed = landings.farthest;
    joined.landed_at = landings.farthest_at;
  }
  drop_doubled_edges(lines, joined);
  return joined;
}

}  // namespace lpq

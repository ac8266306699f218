// Once its lines are divided where they meet, the crossing outlines are a plane map: from the
// outside, where nothing is painted, the winding number of each element changes with its own edges
// alone, and tells by its rule which faces it paints.
#include "io/domain/painted.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/csr.h"
#include "base/disjoint_sets.h"
#include "base/sort_unique.h"
#include "geometry/segment.h"
#include "io/domain/crossings.h"
#include "io/domain/planar_faces.h"

namespace lpq {
namespace {

// Of the drawing's size: outlines this near to each other meet.
constexpr double rounding = 1e-9;
// Steps over edges, for all elements together.
constexpr std::size_t most_steps = 1 << 27;

/// An edge as an element drew it: along the edge of the map, or against it.
struct Use {
  Index source = none;
  int way = 1;
};

struct Map {
  LineWork lines;  // no two edges between the same points
  Csr<Use> uses;   // of each edge
};

Map map_of(const LineWork& divided) {
  struct Drawn {
    Index lo, hi, edge;
    auto operator<=>(const Drawn&) const = default;
  };
  std::vector<Drawn> drawn;
  for (std::size_t e = 0; e < divided.edges.size(); ++e) {
    const auto [lo, hi] = std::minmax(divided.edges[e].a, divided.edges[e].b);
    drawn.push_back({lo, hi, static_cast<Index>(e)});
  }
  std::sort(drawn.begin(), drawn.end());
  Map map{{divided.points, divided.loose, {}}, {}};
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const LineWork::Edge& edge = divided.edges[drawn[i].edge];
    const bool is_new = i == 0 || drawn[i].lo != drawn[i - 1].lo || drawn[i].hi != drawn[i - 1].hi;
    if (is_new && i > 0) map.uses.end_row();
    if (is_new) map.lines.edges.push_back(edge);
    map.uses.values.push_back({edge.source, edge.a == map.lines.edges.back().a ? 1 : -1});
  }
  map.uses.end_row();
  return map;
}

class Painter {
 public:
  Painter(const Map& map, std::span<const FillRule> rules)
      : map_(map),
        rules_(rules),
        sides_(find_sides(map.lines)),
        component_(component_of_points(map.lines, std::vector<char>(map.lines.edges.size(), 1))) {}

  /// False: too many steps.
  bool paint();
  void close_gaps(double tolerance);
  /// Paint on one side alone: the edge with that on its left.
  std::optional<LineWork::Edge> border(std::size_t edge) const;

 private:
  struct Step {
    Index half_edge, from, to;
  };
  std::vector<Step> steps_inwards() const;
  int change(Index half_edge, Index source) const;

  const Map& map_;
  std::span<const FillRule> rules_;
  Sides sides_;
  std::vector<Index> component_;  // #points
  std::vector<char> painted_;     // #walks
};

/// From the walks around components to all others, each once.
std::vector<Painter::Step> Painter::steps_inwards() const {
  const std::size_t count = sides_.is_outer.size();
  const Csr<Index> half_edges = csr_from<Index>(count, [&](auto&& emit) {
    for (std::size_t h = 0; h < sides_.walk.size(); ++h)
      emit(sides_.walk[h], static_cast<Index>(h));
  });
  std::vector<char> known(sides_.is_outer);
  std::vector<Index> reached;
  for (std::size_t w = 0; w < count; ++w)
    if (known[w]) reached.push_back(static_cast<Index>(w));
  std::vector<Step> steps;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const Index h : half_edges.row(reached[i])) {
      const Index to = sides_.walk[h ^ 1];
      if (std::exchange(known[to], 1)) continue;
      steps.push_back({h, reached[i], to});
      reached.push_back(to);
    }
  return steps;
}

/// Of the winding number of what the source drew, from the left of the half-edge to its right.
int Painter::change(Index half_edge, Index source) const {
  int sum = 0;
  for (const Use& use : map_.uses.row(half_edge / 2))
    if (use.source == source) sum += use.way;
  return half_edge % 2 == 0 ? -sum : sum;
}

std::optional<LineWork::Edge> Painter::border(std::size_t edge) const {
  const bool left = painted_[sides_.walk[2 * edge]], right = painted_[sides_.walk[2 * edge + 1]];
  if (left == right) return std::nullopt;
  LineWork::Edge border = map_.lines.edges[edge];
  border.painted = component_[border.a];
  if (right) std::swap(border.a, border.b);
  return border;
}

bool Painter::paint() {
  std::vector<Index> sources;
  for (const Use& use : map_.uses.values) sources.push_back(use.source);
  sort_unique(sources);
  const std::vector<Step> steps = steps_inwards();
  if (steps.size() * sources.size() > most_steps) return false;
  painted_.assign(sides_.is_outer.size(), 0);
  for (const Index source : sources) {
    std::vector<int> winding(painted_.size(), 0);
    for (const Step& step : steps) {
      const int w = winding[step.from] + change(step.half_edge, source);
      winding[step.to] = w;
      if (rules_[source] == FillRule::nonzero ? w != 0 : w % 2 != 0) painted_[step.to] = 1;
    }
  }
  return true;
}

/// Outlines drawn along each other are apart by what rounding makes of them: no gap to be meshed.
void Painter::close_gaps(double tolerance) {
  std::vector<double> twice_area(painted_.size(), 0), length(painted_.size(), 0);
  for (std::size_t h = 0; h < sides_.walk.size(); ++h) {
    const LineWork::Edge& edge = map_.lines.edges[h / 2];
    const Vec2 origin = map_.lines.points[map_.lines.edges.front().a];
    const Vec2 a = map_.lines.points[edge.a] - origin, b = map_.lines.points[edge.b] - origin;
    twice_area[sides_.walk[h]] += h % 2 == 0 ? cross(a, b) : cross(b, a);
    length[sides_.walk[h]] += distance(a, b);
  }
  for (std::size_t w = 0; w < painted_.size(); ++w)
    if (!sides_.is_outer[w] && twice_area[w] < tolerance * length[w]) painted_[w] = 1;
}

struct Parted {
  LineWork alone, crossing;
};

/// The painted outlines that meet others, or themselves, and all other lines.
Parted part(const LineWork& lines, const std::vector<char>& is_painted,
            const std::vector<std::pair<Index, Index>>& meeting) {
  DisjointSets outlines(static_cast<Index>(lines.points.size()));
  for (const LineWork::Edge& edge : lines.edges) outlines.unite(edge.a, edge.b);
  for (const auto& [p, q] : meeting) outlines.unite(p, q);
  std::vector<char> meets(lines.points.size(), 0);
  for (const auto& [p, q] : meeting) meets[outlines.root(p)] = 1;
  Parted parted{{lines.points, lines.loose, {}}, {lines.points, lines.loose, {}}};
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    const bool crosses = is_painted[e] && meets[outlines.root(lines.edges[e].a)];
    (crosses ? parted.crossing : parted.alone).edges.push_back(lines.edges[e]);
  }
  return parted;
}

void append(const LineWork::Edge& edge, const LineWork& from, LineWork& lines) {
  const auto a = static_cast<Index>(lines.points.size());
  for (const Index p : {edge.a, edge.b}) {
    lines.points.push_back(from.points[p]);
    lines.loose.push_back(from.loose[p]);
  }
  lines.edges.push_back({a, a + 1, edge.source, edge.painted});
}

}  // namespace

std::optional<Vec2> unite_painted(LineWork& lines, std::span<const FillRule> rules,
                                  double tolerance) {
  LineWork painted{lines.points, lines.loose, {}};
  std::vector<char> is_painted;
  for (const LineWork::Edge& edge : lines.edges) {
    is_painted.push_back(rules[edge.source] != FillRule::unfilled);
    if (is_painted.back()) painted.edges.push_back(edge);
  }
  const auto is_within_reach = [](Vec2 p) { return std::isfinite(squared_length(p)); };
  if (!std::all_of(lines.points.begin(), lines.points.end(), is_within_reach)) return std::nullopt;
  const auto crossings = find_crossings(painted);
  if (!crossings || crossings->empty()) return std::nullopt;
  std::vector<std::pair<Index, Index>> meeting;
  for (const Crossing& c : *crossings)
    meeting.push_back({painted.edges[c.edge].a, painted.edges[c.other].a});
  Parted parted = part(lines, is_painted, meeting);
  if (!divide_at_crossings(parted.crossing, rounding * drawing_size(lines))) return std::nullopt;
  const Map map = map_of(parted.crossing);
  Painter painter(map, rules);
  if (!painter.paint()) return std::nullopt;
  painter.close_gaps(tolerance);

  const Vec2 place = lines.points[meeting.front().first];
  lines = LineWork();
  for (const LineWork::Edge& edge : parted.alone.edges) append(edge, parted.alone, lines);
  for (std::size_t e = 0; e < map.lines.edges.size(); ++e)
    if (const auto border = painter.border(e)) append(*border, map.lines, lines);
  std::stable_sort(
      lines.edges.begin(), lines.edges.end(),
      [](const LineWork::Edge& e, const LineWork::Edge& f) { return e.source < f.source; });
  merge_equal_points(lines);
  return place;
}

std::vector<char> painted_faces(const LineWork& lines, const NestedFaces& nested) {
  const std::vector<Walk>& faces = nested.planar.faces;
  std::vector<Index> united(faces.size(), none), order;
  std::vector<char> painted(faces.size(), 1), filled(faces.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    order.push_back(static_cast<Index>(f));
    for (std::size_t i = 0; i < faces[f].edges.size(); ++i) {
      const LineWork::Edge& edge = lines.edges[faces[f].edges[i]];
      if (edge.painted == none) continue;
      united[f] = edge.painted;
      painted[f] = edge.a == faces[f].points[i];  // faces are to the left of their walks
    }
  }
  std::stable_sort(order.begin(), order.end(), [&nested](Index f, Index g) {
    return nested.tree.depth[f] < nested.tree.depth[g];
  });
  for (const Index f : order) {
    Index around = nested.tree.parent[f];
    while (around != none && united[f] != none && united[around] == united[f])
      around = nested.tree.parent[around];
    filled[f] = painted[f] != (around != none && filled[around]);
  }
  return filled;
}

}  // namespace lpq

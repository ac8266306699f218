// Once its lines are divided where they meet, the crossing outlines are a plane map: from the
// outside, where nothing is painted, the winding number of each element changes with its own edges
// alone, and tells by its rule which faces it paints. All outlines of an element count there: a
// shape that crosses the border of a hole alone lies in what is painted around the hole.
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

  /// False: more steps than `steps_left`, from which they are taken.
  bool paint(std::size_t& steps_left);
  void close_gaps(double tolerance);
  /// Paint on one side alone: the edge with that on its left.
  std::optional<LineWork::Edge> border(std::size_t edge) const;

 private:
  struct Step {
    Index half_edge, from, to;  // none: to a part of the map that lies in a face
  };
  Csr<Index> parts_within() const;
  std::vector<Step> steps_inwards() const;
  int change(Index half_edge, Index source) const;

  const Map& map_;
  std::span<const FillRule> rules_;
  Sides sides_;
  std::vector<Index> component_;  // #points
  std::vector<char> painted_;     // #walks
};

/// Of each face's walk: those around the parts that lie in the face.
Csr<Index> Painter::parts_within() const {
  const std::vector<LineWork::Edge>& edges = map_.lines.edges;
  std::vector<Index> outer(component_.size(), none), around(component_.size(), none);
  for (std::size_t h = 0; h < sides_.walk.size(); ++h)
    if (sides_.is_outer[sides_.walk[h]]) outer[component_[edges[h / 2].a]] = sides_.walk[h];
  const NestedFaces nested = nest_faces(map_.lines);
  const std::vector<Walk>& faces = nested.planar.faces;
  const auto note = [&](const Walk& walk, Index face) {
    if (face == none) return;
    const Index e = faces[face].edges.front(), start = faces[face].points.front();
    const Index part = component_[walk.points.front()];
    if (component_[start] != part) around[part] = sides_.walk[2 * e + (edges[e].a != start)];
  };
  for (std::size_t f = 0; f < faces.size(); ++f) note(faces[f], nested.tree.parent[f]);
  for (std::size_t c = 0; c < nested.planar.chains.size(); ++c)
    note(nested.planar.chains[c], nested.around_chain(c));
  return csr_from<Index>(sides_.is_outer.size(), [&](auto&& emit) {
    for (std::size_t i = 0; i < around.size(); ++i)
      if (around[i] != none && outer[i] != none) emit(around[i], outer[i]);
  });
}

/// From the outside to all walks, each once.
std::vector<Painter::Step> Painter::steps_inwards() const {
  const std::size_t count = sides_.is_outer.size();
  const Csr<Index> within = parts_within();
  const Csr<Index> half_edges = csr_from<Index>(count, [&](auto&& emit) {
    for (std::size_t h = 0; h < sides_.walk.size(); ++h)
      emit(sides_.walk[h], static_cast<Index>(h));
  });
  std::vector<char> known(sides_.is_outer);
  for (const Index part : within.values) known[part] = 0;
  std::vector<Index> reached;
  for (std::size_t w = 0; w < count; ++w)
    if (known[w]) reached.push_back(static_cast<Index>(w));
  std::vector<Step> steps;
  const auto reach = [&](Index h, Index from, Index to) {
    if (std::exchange(known[to], 1)) return;
    steps.push_back({h, from, to});
    reached.push_back(to);
  };
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Index from = reached[i];
    for (const Index h : half_edges.row(from)) reach(h, from, sides_.walk[h ^ 1]);
    for (const Index part : within.row(from)) reach(none, from, part);
  }
  return steps;
}

/// Of the winding number of what the source drew, from the left of the half-edge to its right.
int Painter::change(Index half_edge, Index source) const {
  if (half_edge == none) return 0;
  int sum = 0;
  for (const Use& use : map_.uses.row(half_edge / 2))
    if (use.source == source) sum += use.way;
  return half_edge % 2 == 0 ? -sum : sum;
}

std::optional<LineWork::Edge> Painter::border(std::size_t edge) const {
  const bool left = painted_[sides_.walk[2 * edge]], right = painted_[sides_.walk[2 * edge + 1]];
  if (left == right) return std::nullopt;
  LineWork::Edge border = map_.lines.edges[edge];
  border.outline = none;
  border.bow = 0;
  if (right) std::swap(border.a, border.b);
  return border;
}

bool Painter::paint(std::size_t& steps_left) {
  std::vector<Index> sources;
  for (const Use& use : map_.uses.values) sources.push_back(use.source);
  sort_unique(sources);
  const std::vector<Step> steps = steps_inwards();
  if (steps.size() > steps_left / sources.size()) return false;
  steps_left -= steps.size() * sources.size();
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

/// What hangs together, also as outlines of one of the sources: first the points, then the sources.
DisjointSets sets_of(const LineWork& lines, std::size_t sources) {
  const auto points = static_cast<Index>(lines.points.size());
  DisjointSets sets(points + static_cast<Index>(sources));
  for (const LineWork::Edge& edge : lines.edges) {
    sets.unite(edge.a, edge.b);
    sets.unite(edge.a, points + edge.source);
  }
  return sets;
}

/// The outlines of painted elements that meet others, or themselves, and all other lines.
Parted part(const LineWork& lines, const std::vector<char>& is_painted,
            const std::vector<std::pair<Index, Index>>& meeting, std::size_t sources) {
  DisjointSets outlines = sets_of(lines, sources);
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
  lines.edges.push_back(edge);
  lines.edges.back().a = a;
  lines.edges.back().b = a + 1;
}

/// The edges, by what hangs together.
Csr<Index> groups_of(const LineWork& lines, std::size_t sources) {
  DisjointSets sets = sets_of(lines, sources);
  std::vector<Index> number(lines.points.size() + sources, none), group;
  Index count = 0;
  for (const LineWork::Edge& edge : lines.edges) {
    Index& known = number[sets.root(edge.a)];
    if (known == none) known = count++;
    group.push_back(known);
  }
  return members_of(group, static_cast<std::size_t>(count));
}

/// The borders of what divided outlines paint, group by group: what lies within a group without
/// meeting it is not painted over by it. Nothing: too many steps.
std::optional<LineWork> painted_borders(const LineWork& divided, std::span<const FillRule> rules,
                                        double tolerance) {
  LineWork borders;
  std::size_t steps_left = most_steps;
  const Csr<Index> groups = groups_of(divided, rules.size());
  for (Index g = 0; g < groups.rows(); ++g) {
    LineWork own;
    for (const Index e : groups.row(g)) append(divided.edges[e], divided, own);
    merge_equal_points(own);
    const Map map = map_of(own);
    Painter painter(map, rules);
    if (!painter.paint(steps_left)) return std::nullopt;
    painter.close_gaps(tolerance);
    for (std::size_t e = 0; e < map.lines.edges.size(); ++e) {
      auto border = painter.border(e);
      if (!border) continue;
      border->painted = g;
      append(*border, map.lines, borders);
    }
  }
  return borders;
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
  Parted parted = part(lines, is_painted, meeting, rules.size());
  if (!divide_at_crossings(parted.crossing, rounding * drawing_size(lines))) return std::nullopt;
  const auto borders = painted_borders(parted.crossing, rules, tolerance);
  if (!borders) return std::nullopt;

  const Vec2 place = lines.points[meeting.front().first];
  lines = LineWork();
  for (const LineWork::Edge& edge : parted.alone.edges) append(edge, parted.alone, lines);
  for (const LineWork::Edge& edge : borders->edges) append(edge, *borders, lines);
  std::stable_sort(
      lines.edges.begin(), lines.edges.end(),
      [](const LineWork::Edge& e, const LineWork::Edge& f) { return e.source < f.source; });
  merge_equal_points(lines);
  return place;
}

}  // namespace lpq

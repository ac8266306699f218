// Edges sorted around every vertex are all there is to a plane map [de Berg et al. 2008, 2.2]: the
// walk that leaves every vertex by the edge clockwise next to the one it came by keeps its face on
// the left. An edge whose two sides are on the same walk is a bridge or hangs loose: it divides
// nothing. Without these edges the walks are the outlines of faces (left turns in total) and of
// components (right turns).
#include "io/domain/planar_faces.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "domain/directions.h"
#include "geometry/frame.h"
#include "geometry/polygon.h"

namespace lpq {
namespace {

// Half-edge 2 e runs along edge e, 2 e + 1 against it.
class Tracer {
 public:
  explicit Tracer(const LineWork& lines) : lines_(lines), frame_(fit_frame(lines.points)) {}

  /// The walks over the edges with used[e], in order of their first half-edges.
  void trace(const std::vector<char>& used);
  Index walk_of(Index half_edge) const { return walk_[half_edge]; }
  Index walk_count() const { return static_cast<Index>(first_.size()); }
  Walk walk(Index number) const;
  int orientation_of(const Walk& walk) const;

 private:
  Index origin(Index h) const {
    const LineWork::Edge& edge = lines_.edges[h / 2];
    return h % 2 == 0 ? edge.a : edge.b;
  }
  Vec2 at(Index point) const { return frame_.to_frame(lines_.points[point]); }
  void sort_around(std::vector<Index>& outgoing, std::size_t begin, std::size_t end) const;

  const LineWork& lines_;
  UnitFrame frame_;
  std::vector<Index> next_, walk_, first_;
};

void Tracer::sort_around(std::vector<Index>& outgoing, std::size_t begin, std::size_t end) const {
  const Counterclockwise before{at(origin(outgoing[begin]))};
  std::stable_sort(outgoing.begin() + static_cast<std::ptrdiff_t>(begin),
                   outgoing.begin() + static_cast<std::ptrdiff_t>(end),
                   [&](Index g, Index h) { return before(at(origin(g ^ 1)), at(origin(h ^ 1))); });
}

void Tracer::trace(const std::vector<char>& used) {
  const std::size_t count = 2 * lines_.edges.size();
  std::vector<Index> outgoing;
  for (std::size_t h = 0; h < count; ++h)
    if (used[h / 2]) outgoing.push_back(static_cast<Index>(h));
  std::stable_sort(outgoing.begin(), outgoing.end(),
                   [this](Index g, Index h) { return origin(g) < origin(h); });
  next_.assign(count, none);
  for (std::size_t i = 0, j = 0; i < outgoing.size(); i = j) {
    while (j < outgoing.size() && origin(outgoing[j]) == origin(outgoing[i])) ++j;
    if (j - i > 2) sort_around(outgoing, i, j);
    for (std::size_t k = i; k < j; ++k) next_[outgoing[k] ^ 1] = outgoing[k == i ? j - 1 : k - 1];
  }
  walk_.assign(count, none);
  first_.clear();
  for (std::size_t start = 0; start < count; ++start) {
    if (next_[start] == none || walk_[start] != none) continue;
    for (auto h = static_cast<Index>(start); walk_[h] == none; h = next_[h])
      walk_[h] = walk_count();
    first_.push_back(static_cast<Index>(start));
  }
}

Walk Tracer::walk(Index number) const {
  Walk walk;
  // From the start of its first edge, whichever way that was drawn.
  const Index start = first_[number] % 2 == 0 ? first_[number] : next_[first_[number]];
  Index h = start;
  do {
    walk.points.push_back(origin(h));
    walk.edges.push_back(h / 2);
    h = next_[h];
  } while (h != start);
  return walk;
}

int Tracer::orientation_of(const Walk& walk) const {
  std::vector<Vec2> polygon;
  for (const Index p : walk.points) polygon.push_back(at(p));
  return orientation(polygon);
}

/// Chains of edges, broken where an edge of another kind or source joins, in order of first edges.
class ChainMaker {
 public:
  ChainMaker(const LineWork& lines, const std::vector<char>& divides)
      : lines_(lines),
        at_(lines.points.size(), {none, none}),
        stops_(lines.points.size(), 0),
        done_(divides) {
    for (std::size_t e = 0; e < lines.edges.size(); ++e) {
      for (const Index p : {lines.edges[e].a, lines.edges[e].b}) {
        if (divides[e] || at_[p].second != none) {
          stops_[p] = 1;
        } else {
          (at_[p].first == none ? at_[p].first : at_[p].second) = static_cast<Index>(e);
        }
      }
    }
  }

  std::vector<Walk> make() {
    std::vector<Walk> chains;
    for (Index e = 0; e < static_cast<Index>(done_.size()); ++e) {
      if (done_[e]) continue;
      const Walk back = follow(e, lines_.edges[e].b);  // to where the chain begins
      for (const Index f : back.edges) done_[f] = 0;
      chains.push_back(follow(back.edges.back(), back.points.back()));
    }
    return chains;
  }

 private:
  /// The chain that starts at `from` with edge e and goes on as long as it can.
  Walk follow(Index e, Index from) {
    Walk chain;
    chain.points.push_back(from);
    while (true) {
      const LineWork::Edge& edge = lines_.edges[e];
      done_[e] = 1;
      from = from == edge.a ? edge.b : edge.a;
      chain.points.push_back(from);
      chain.edges.push_back(e);
      const Index after = at_[from].first == e ? at_[from].second : at_[from].first;
      if (stops_[from] || after == none || done_[after]) return chain;
      if (lines_.edges[after].source != edge.source) return chain;
      e = after;
    }
  }

  const LineWork& lines_;
  std::vector<std::pair<Index, Index>> at_;  // the edges at a point
  std::vector<char> stops_;                  // a chain ends at this point
  std::vector<char> done_;
};

}  // namespace

std::vector<Index> component_of_points(const LineWork& lines, const std::vector<char>& used) {
  DisjointSets components(static_cast<Index>(lines.points.size()));
  for (std::size_t e = 0; e < lines.edges.size(); ++e)
    if (used[e]) components.unite(lines.edges[e].a, lines.edges[e].b);
  std::vector<Index> component(lines.points.size());
  for (std::size_t i = 0; i < component.size(); ++i)
    component[i] = components.root(static_cast<Index>(i));
  return component;
}

Sides find_sides(const LineWork& lines) {
  Tracer tracer(lines);
  tracer.trace(std::vector<char>(lines.edges.size(), 1));
  Sides sides;
  for (Index h = 0; h < static_cast<Index>(2 * lines.edges.size()); ++h)
    sides.walk.push_back(tracer.walk_of(h));
  for (Index w = 0; w < tracer.walk_count(); ++w)
    sides.is_outer.push_back(tracer.orientation_of(tracer.walk(w)) <= 0);
  return sides;
}

PlanarFaces find_faces(const LineWork& lines) {
  std::vector<char> divides(lines.edges.size(), 1);
  Tracer tracer(lines);
  tracer.trace(divides);
  for (std::size_t e = 0; e < divides.size(); ++e) {
    const auto h = static_cast<Index>(2 * e);
    divides[e] = tracer.walk_of(h) != tracer.walk_of(h + 1);
  }
  PlanarFaces result;
  result.chains = ChainMaker(lines, divides).make();
  tracer.trace(divides);
  const std::vector<Index> component = component_of_points(lines, divides);
  for (Index w = 0; w < tracer.walk_count(); ++w) {
    Walk walk = tracer.walk(w);
    walk.component = component[walk.points.front()];
    // What encloses nothing in total crosses itself: it goes to the door as a face.
    const bool outer = tracer.orientation_of(walk) < 0;
    (outer ? result.outers : result.faces).push_back(std::move(walk));
  }
  return result;
}

}  // namespace lpq

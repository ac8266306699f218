// Douglas and Peucker [1973] on every run of vertices between fixed corners; then, as long as a new
// edge meets another one or sweeps over a kept point, that edge is split at its farthest vertex.
// In the end, if need be, the edges are the given ones, which are known to be sound.
#include "domain/simplify.h"

#include <algorithm>
#include <utility>

#include "domain/box_tree.h"
#include "domain/conflicts.h"
#include "geometry/polygon.h"
#include "geometry/segment.h"

namespace lpq {
namespace {

/// An edge of the new boundary: it replaces members first .. last - 1 of a run.
struct Chord {
  Index run, first, last;
};

class Simplification {
 public:
  Simplification(const Domain& domain, double tolerance) : domain_(domain), tolerance_(tolerance) {}
  SimplifiedBoundary run();

 private:
  // Segments head to tail; vertex k is the start of segment k, the last one its end.
  using Run = std::vector<Index>;

  void find_runs();
  void add_run(Index first, const std::vector<Index>& following, std::vector<char>& taken);
  void approximate(Chord chord);
  std::pair<Index, double> farthest(const Chord& chord) const;
  SimplifiedBoundary build() const;
  std::vector<char> find_bad(const SimplifiedBoundary& boundary) const;
  bool sweeps_over_a_point(const Chord& chord, const BoxTree& points,
                           const std::vector<Index>& names) const;

  Index vertex(const Chord& chord, Index k) const {
    const Run& run = runs_[chord.run];
    return k < static_cast<Index>(run.size()) ? domain_.segments[run[k]].a
                                              : domain_.segments[run.back()].b;
  }
  Vec2 at(const Chord& chord, Index k) const { return domain_.points[vertex(chord, k)]; }

  const Domain& domain_;
  double tolerance_;
  std::vector<Run> runs_;
  std::vector<Chord> chords_;
};

bool alike(const Segment& s, const Segment& t) {
  return s.left == t.left && s.right == t.right && s.tag == t.tag && s.region == t.region &&
         s.loop == t.loop && s.reversed == t.reversed;
}

void Simplification::find_runs() {
  const Index n = static_cast<Index>(domain_.points.size());
  const Index count = static_cast<Index>(domain_.segments.size());
  std::vector<Index> in(n, none), out(n, none), degree(n, 0);
  for (Index i = 0; i < count; ++i) {
    const Segment& s = domain_.segments[i];
    out[s.a] = i;
    in[s.b] = i;
    ++degree[s.a];
    ++degree[s.b];
  }
  const auto free = [&](Index v) {
    return degree[v] == 2 && in[v] != none && out[v] != none && domain_.point_tag[v] == none &&
           alike(domain_.segments[in[v]], domain_.segments[out[v]]);
  };
  std::vector<Index> following(count, none);
  for (Index i = 0; i < count; ++i)
    if (const Index v = domain_.segments[i].b; free(v)) following[i] = out[v];
  std::vector<char> taken(count, 0);
  for (Index i = 0; i < count; ++i)
    if (!free(domain_.segments[i].a)) add_run(i, following, taken);
  // What is left are loops without a fixed corner; they start at their smallest point.
  for (Index i = 0; i < count; ++i)
    if (!taken[i]) add_run(i, following, taken);
}

void Simplification::add_run(Index first, const std::vector<Index>& following,
                             std::vector<char>& taken) {
  Run run;
  for (Index i = first; i != none && !taken[i]; i = following[i]) {
    taken[i] = 1;
    run.push_back(i);
  }
  const Index number = static_cast<Index>(runs_.size()), size = static_cast<Index>(run.size());
  const bool closed = domain_.segments[run.back()].b == domain_.segments[run.front()].a;
  runs_.push_back(std::move(run));
  if (!closed) return approximate({number, 0, size});
  const Index middle = farthest({number, 0, size}).first;
  approximate({number, 0, middle});
  approximate({number, middle, size});
}

/// The vertex farthest from the chord's line piece (from its start if it is closed).
std::pair<Index, double> Simplification::farthest(const Chord& chord) const {
  const Vec2 a = at(chord, chord.first), b = at(chord, chord.last);
  Index best = chord.first + 1;
  double distance_of_best = -1;
  for (Index k = chord.first + 1; k < chord.last; ++k) {
    const Vec2 p = at(chord, k);
    const double d = distance(p, closest_point(p, a, b));
    if (d > distance_of_best) {
      best = k;
      distance_of_best = d;
    }
  }
  return {best, std::max(distance_of_best, 0.0)};
}

void Simplification::approximate(Chord chord) {
  std::vector<Chord> waiting{chord};
  while (!waiting.empty()) {
    const Chord c = waiting.back();
    waiting.pop_back();
    const auto [k, d] = farthest(c);
    if (c.last - c.first == 1 || d <= tolerance_) {
      chords_.push_back(c);
      continue;
    }
    waiting.push_back({c.run, k, c.last});
    waiting.push_back({c.run, c.first, k});
  }
}

SimplifiedBoundary Simplification::build() const {
  SimplifiedBoundary result;
  result.used.assign(domain_.points.size(), 1);
  for (const Chord& chord : chords_) {
    const Run& run = runs_[chord.run];
    Segment segment = domain_.segments[run[chord.first]];
    segment.b = vertex(chord, chord.last);
    if (segment.reversed) segment.edge = domain_.segments[run[chord.last - 1]].edge;
    result.segments.push_back(segment);
    for (Index k = chord.first + 1; k < chord.last; ++k) result.used[vertex(chord, k)] = 0;
    if (chord.last - chord.first > 1)
      result.deviation = std::max(result.deviation, farthest(chord).second);
  }
  return result;
}

// A point changes sides if it lies between the dropped vertices and the chord (even-odd rule).
bool Simplification::sweeps_over_a_point(const Chord& chord, const BoxTree& points,
                                         const std::vector<Index>& names) const {
  std::vector<Vec2> swept;
  for (Index k = chord.first; k <= chord.last; ++k) swept.push_back(at(chord, k));
  const Box box = box_of(swept);
  bool found = false;
  points.walk([&](Index, const Box& other) { return !found && overlap(box, other); },
              [&](Index i) {
                const Index v = names[i];
                if (v == vertex(chord, chord.first) || v == vertex(chord, chord.last)) return;
                found = found || locate(domain_.points[v], swept) != Side::outside;
              });
  return found;
}

std::vector<char> Simplification::find_bad(const SimplifiedBoundary& boundary) const {
  std::vector<char> bad(chords_.size(), 0);
  for (const Index i : meeting_edges(domain_.points, boundary.segments)) bad[i] = 1;
  std::vector<Index> names;
  std::vector<Box> boxes;
  for (Index v = 0; v < static_cast<Index>(boundary.used.size()); ++v) {
    if (!boundary.used[v]) continue;
    names.push_back(v);
    boxes.push_back({domain_.points[v], domain_.points[v]});
  }
  const BoxTree points(boxes);
  for (std::size_t i = 0; i < chords_.size(); ++i) {
    if (chords_[i].last - chords_[i].first < 2)
      bad[i] = 0;  // a given edge: whatever it meets is not
    else if (!bad[i])
      bad[i] = sweeps_over_a_point(chords_[i], points, names);
  }
  return bad;
}

SimplifiedBoundary Simplification::run() {
  find_runs();
  for (;;) {
    SimplifiedBoundary boundary = build();
    const std::vector<char> bad = find_bad(boundary);
    if (std::find(bad.begin(), bad.end(), 1) == bad.end()) return boundary;
    std::vector<Chord> split;
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      const Chord& c = chords_[i];
      if (!bad[i]) {
        split.push_back(c);
        continue;
      }
      const Index k = farthest(c).first;
      split.push_back({c.run, c.first, k});
      split.push_back({c.run, k, c.last});
    }
    chords_ = std::move(split);
  }
}

}  // namespace

SimplifiedBoundary simplify_boundary(const Domain& domain, double tolerance) {
  if (!(tolerance > 0)) return {domain.segments, std::vector<char>(domain.points.size(), 1), 0.0};
  return Simplification(domain, tolerance).run();
}

}  // namespace lpq

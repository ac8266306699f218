#include "surface/charts/split.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "surface/fans.h"
#include "surface/frames.h"

namespace lpq {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int recentrings = 3;
constexpr int smoothings = 4;

using Entry = std::pair<double, Index>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

// A triangle with two neighbours of another piece goes to them: teeth of the border vanish. Returns
// false, with the labels as they were, if a piece vanished too.
bool smooth_labels(const Part& part, Index pieces, std::vector<Index>& labels) {
  const std::vector<Index> before = labels;
  for (int pass = 0; pass < smoothings; ++pass) {
    bool changed = false;
    for (Index t = 0; t < part.triangle_count(); ++t) {
      Index others[3] = {none, none, none};
      for (Index k = 0; k < 3; ++k)
        if (part.twins[3 * t + k] != none) others[k] = labels[triangle_of(part.twins[3 * t + k])];
      for (int k = 0; k < 3; ++k) {
        const Index other = others[k];
        if (other == none || other == labels[t] || other != others[(k + 1) % 3]) continue;
        labels[t] = other;
        changed = true;
        break;
      }
    }
    if (!changed) break;
  }
  for (Index piece = 0; piece < pieces; ++piece) {
    if (std::find(labels.begin(), labels.end(), piece) != labels.end()) continue;
    labels = before;
    return false;
  }
  return true;
}

}  // namespace

struct Splitter::Search {
  std::vector<double> distance;
  std::vector<Index> owner;
  Queue queue;

  explicit Search(Index count) : distance(count, infinite), owner(count, none) {}
  void start(Index t, Index label) {
    distance[t] = 0;
    owner[t] = label;
    queue.push({0.0, t});
  }
};

Splitter::Splitter(const SurfaceMesh& mesh) {
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    centroid_.push_back((1.0 / 3) * (mesh.points[a] + mesh.points[b] + mesh.points[c]));
    normal_.push_back(axes_of(mesh, t).normal);
  }
}

// Across every half-edge of the part; 0 where there is no other side.
std::vector<double> Splitter::steps_of(const Part& part, double bending) const {
  std::vector<double> steps;
  steps.reserve(part.twins.size());
  for (Index e = 0; e < static_cast<Index>(part.twins.size()); ++e) {
    const Index a = part.triangles[triangle_of(e)];
    const Index b = part.twins[e] == none ? a : part.triangles[triangle_of(part.twins[e])];
    steps.push_back(distance(centroid_[a], centroid_[b]) *
                    (1 + bending * (1 - dot(normal_[a], normal_[b]))));
  }
  return steps;
}

// Dijkstra over neighbouring triangles; where owners are set already, only inside their pieces.
void Splitter::spread(const Part& part, std::span<const double> steps, Search& search) const {
  while (!search.queue.empty()) {
    const auto [d, t] = search.queue.top();
    search.queue.pop();
    if (d > search.distance[t]) continue;
    for (Index e = 3 * t; e < 3 * t + 3; ++e) {
      if (part.twins[e] == none) continue;
      const Index other = triangle_of(part.twins[e]);
      const double there = d + steps[e];
      if (!(there < search.distance[other])) continue;
      search.distance[other] = there;
      search.owner[other] = search.owner[t];
      search.queue.push({there, other});
    }
  }
}

// In each piece the triangle farthest from its border.
std::vector<Index> Splitter::centres(const Part& part, std::span<const double> steps,
                                     const std::vector<Index>& owner, std::size_t pieces) const {
  Search search(part.triangle_count());
  for (Index e = 0; e < static_cast<Index>(part.twins.size()); ++e) {
    const Index t = triangle_of(e), twin = part.twins[e];
    if (search.owner[t] == none && (twin == none || owner[triangle_of(twin)] != owner[t]))
      search.start(t, owner[t]);
  }
  spread(part, steps, search);
  std::vector<Index> centre(pieces, none);
  for (Index t = 0; t < part.triangle_count(); ++t) {
    if (owner[t] == none) continue;
    Index& best = centre[owner[t]];
    if (best == none || search.distance[t] > search.distance[best]) best = t;
  }
  return centre;
}

std::vector<Index> Splitter::far_pieces(const Part& part, Index pieces, double bending) const {
  const auto farthest = [](const Search& search) {
    Index best = 0;
    for (Index t = 0; t < static_cast<Index>(search.distance.size()); ++t)
      if (search.distance[t] < infinite && search.distance[t] > search.distance[best]) best = t;
    return best;
  };
  const std::vector<double> steps = steps_of(part, bending);  // asked for up to nine times
  Search first(part.triangle_count());
  first.start(0, 0);
  spread(part, steps, first);
  std::vector<Index> seeds{farthest(first)};
  Search search(part.triangle_count());
  search.start(seeds[0], 0);
  spread(part, steps, search);
  while (static_cast<Index>(seeds.size()) < pieces) {
    seeds.push_back(farthest(search));
    search.start(seeds.back(), static_cast<Index>(seeds.size()) - 1);
    spread(part, steps, search);
  }
  for (int i = 0; i < recentrings; ++i) {
    std::vector<Index> better = centres(part, steps, search.owner, seeds.size());
    if (better == seeds || std::count(better.begin(), better.end(), none) > 0) break;
    seeds = std::move(better);
    search = Search(part.triangle_count());
    for (std::size_t s = 0; s < seeds.size(); ++s) search.start(seeds[s], static_cast<Index>(s));
    spread(part, steps, search);
  }
  smooth_labels(part, pieces, search.owner);
  return std::move(search.owner);
}

// Dijkstra along edges; it ends at the first vertex of another loop, so the way touches borders
// with its ends only.
std::vector<Index> Splitter::way_to_next_loop(const Part& part) const {
  const SurfaceFans fans = fans_of(part.twins);  // numbered as the part's vertices
  std::vector<Index> loop_of(part.vertex.size(), none);
  for (Index loop = 0; loop < part.loops.rows(); ++loop)
    for (const Index e : part.loops.row(loop)) loop_of[part.origin(e)] = loop;
  std::vector<double> reached(part.vertex.size(), infinite);
  std::vector<Index> came_by(part.vertex.size(), none);  // own half-edge, either direction
  Queue queue;
  for (const Index e : part.loops.row(0)) {
    reached[part.origin(e)] = 0;
    queue.push({0.0, part.origin(e)});
  }
  const auto follow = [&](Index v, Index e, Index to) {
    const double there = reached[v] + part.length[e];
    if (part.twins[e] == none || !(there < reached[to])) return;
    reached[to] = there;
    came_by[to] = e;
    queue.push({there, to});
  };
  std::vector<Index> way;
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > reached[v]) continue;
    if (loop_of[v] > 0) {
      for (Index at = v; came_by[at] != none;) {
        const Index e = came_by[at];
        way.push_back(part.on_surface(e));
        at = part.origin(e) == at ? part.target(e) : part.origin(e);
      }
      break;
    }
    for (const Index e : fans.corners.row(v)) {
      follow(v, e, part.target(e));
      follow(v, prev_in_triangle(e), part.origin(prev_in_triangle(e)));
    }
  }
  return way;
}

void cut_between(const Part& part, std::span<const Index> labels, std::span<char> cut) {
  for (Index e = 0; e < static_cast<Index>(part.twins.size()); ++e)
    if (part.twins[e] != none && labels[triangle_of(e)] != labels[triangle_of(part.twins[e])])
      cut[part.on_surface(e)] = 1;
}

}  // namespace lpq

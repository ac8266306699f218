#include "field/inside.h"

#include <set>

#include "base/sort_numbers.h"
#include "geometry/predicates.h"

namespace lpq {
namespace {

// A wall directed upwards; horizontal walls never decide and are left out. It is active for
// low.y <= y < high.y, so a sweep line through a node sees each wall of a chain once.
struct Wall {
  Vec2 low, high;
  Index right = none;  // region on the right of low -> high
};

// Left-to-right order of walls that share a sweep line; they do not cross, so one end decides.
struct LeftOf {
  using is_transparent = void;
  const std::vector<Wall>* walls;

  bool operator()(Index i, Index j) const {
    const Wall &s = (*walls)[i], &t = (*walls)[j];
    if (s.low.y >= t.low.y) {
      const int side = orient2d(t.low, t.high, s.low);
      if (side != 0) return side > 0;
      const int upper = orient2d(t.low, t.high, s.high);
      return upper != 0 ? upper > 0 : i < j;
    }
    const int side = orient2d(s.low, s.high, t.low);
    if (side != 0) return side < 0;
    const int upper = orient2d(s.low, s.high, t.high);
    return upper != 0 ? upper < 0 : i < j;
  }
  bool operator()(Index i, Vec2 p) const {
    return orient2d((*walls)[i].low, (*walls)[i].high, p) <= 0;
  }
  bool operator()(Vec2 p, Index i) const {
    return orient2d((*walls)[i].low, (*walls)[i].high, p) > 0;
  }
};

std::vector<Wall> upward_walls(const BoundaryMesh& boundary) {
  std::vector<Wall> walls;
  walls.reserve(boundary.edges.size());
  for (const Segment& s : boundary.edges) {
    const Vec2 a = boundary.points[s.a], b = boundary.points[s.b];
    if (a.y < b.y) walls.push_back({a, b, s.right});
    if (b.y < a.y) walls.push_back({b, a, s.left});
  }
  return walls;
}

std::vector<Index> order_of(const std::vector<double>& heights) {
  return sorted_numbers(heights.size(), [&](Index i, Index j) {
    return heights[i] != heights[j] ? heights[i] < heights[j] : i < j;
  });
}

template <class Things, class Height>
std::vector<Index> sorted_by(const Things& things, Height height) {
  std::vector<double> heights;
  heights.reserve(things.size());
  for (const auto& thing : things) heights.push_back(height(thing));
  return order_of(heights);
}

}  // namespace

std::vector<Index> regions_of(const BoundaryMesh& boundary, std::span<const Vec2> points) {
  const std::vector<Wall> walls = upward_walls(boundary);
  const auto starts = sorted_by(walls, [](const Wall& wall) { return wall.low.y; });
  const auto ends = sorted_by(walls, [](const Wall& wall) { return wall.high.y; });
  const auto queries = sorted_by(points, [](Vec2 p) { return p.y; });
  std::vector<Index> region(points.size(), none);
  using Active = std::set<Index, LeftOf>;
  Active active(LeftOf{&walls});
  std::vector<Active::iterator> position(walls.size());
  std::size_t next_start = 0, next_end = 0;
  for (const Index q : queries) {
    const double y = points[q].y;
    // Events in order of height; at equal heights walls end before others start.
    while (true) {
      const bool ending = next_end < ends.size() && walls[ends[next_end]].high.y <= y;
      const bool starting = next_start < starts.size() && walls[starts[next_start]].low.y <= y;
      if (!ending && !starting) break;
      if (ending &&
          (!starting || walls[ends[next_end]].high.y <= walls[starts[next_start]].low.y)) {
        active.erase(position[ends[next_end++]]);
      } else {
        const Index wall = starts[next_start++];
        position[wall] = active.insert(wall).first;
      }
    }
    const auto beyond = active.upper_bound(points[q]);
    if (beyond != active.begin()) region[q] = walls[*std::prev(beyond)].right;
  }
  return region;
}

}  // namespace lpq

// See hanging.h.
#include "surface/hanging.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>

#include "surface/edges.h"

namespace lpq {
namespace {

constexpr double long_edge = 10;     // times the reach
constexpr std::ptrdiff_t most = 64;  // border edges at a point; more are parts that meet there only

class Zip {
 public:
  Zip(std::span<const Vec3> points, double reach, std::vector<Tri>& triangles,
      std::vector<Index>& group)
      : points_(points), reach_(reach), triangles_(triangles), group_(group) {
    const auto edges = surface_edges(triangles, static_cast<Index>(points.size()));
    for (Index e = 0; e < edges.count(); ++e)
      if (edges.half_edges.row(e).size() == 1)
        add(edges.ends[e][0], edges.ends[e][1], triangle_of(edges.half_edges.row(e)[0]));
  }

  Index run() {
    std::vector<Index> starts;
    for (const auto& [ends, triangle] : border_) starts.push_back(ends[0]);
    while (!starts.empty()) {
      const Index start = starts.back();
      starts.pop_back();
      while (const auto step = step_from(start)) {
        divide(start, step->far, step->near);
        starts.push_back(step->near);
        ++shared_;
      }
    }
    return shared_;
  }

 private:
  struct Step {
    Index near = none, far = none;  // ends of two border edges; the first lies on the other edge
  };
  using Ends = std::array<Index, 2>;

  /// What two triangles have is no border any more.
  void add(Index a, Index b, Index triangle) {
    if (!border_.insert({{a, b}, triangle}).second) return remove(a, b);
    border_[{b, a}] = triangle;
  }
  void remove(Index a, Index b) {
    border_.erase({a, b});
    border_.erase({b, a});
  }

  std::optional<Step> step_from(Index start) const {
    const auto first = border_.lower_bound({start, 0}), last = border_.lower_bound({start + 1, 0});
    int count = 0;
    for (auto at = first; at != last; ++at)
      if (++count > most) return std::nullopt;
    for (auto far = first; far != last; ++far)
      for (auto near = first; near != last; ++near) {
        const Tri& t = triangles_[far->second];
        const Index hanging = near->first[1];
        if (std::find(t.begin(), t.end(), hanging) == t.end() &&
            hangs(start, far->first[1], hanging))
          return Step{hanging, far->first[1]};
      }
    return std::nullopt;
  }

  bool hangs(Index start, Index end, Index point) const {
    const Vec3 edge = points_[end] - points_[start], way = points_[point] - points_[start];
    const double whole = length(edge), least = long_edge * reach_;
    const double along = dot(edge, way) / whole;
    return along > least && along < whole - least && length(way - (along / whole) * edge) <= reach_;
  }

  void divide(Index start, Index end, Index point) {
    const Index old = border_.at({start, end});
    const auto added = static_cast<Index>(triangles_.size());
    Tri rest = triangles_[old];
    std::replace(rest.begin(), rest.end(), start, point);
    std::replace(triangles_[old].begin(), triangles_[old].end(), end, point);
    triangles_.push_back(rest);
    group_.push_back(Index{group_[old]});
    remove(start, end);
    remove(start, point);
    for (const Index v : rest)
      if (const auto at = border_.find({v, end}); at != border_.end() && at->second == old)
        at->second = border_.at({end, v}) = added;
    add(point, end, added);
  }

  std::span<const Vec3> points_;
  double reach_;
  std::vector<Tri>& triangles_;
  std::vector<Index>& group_;
  std::map<Ends, Index> border_;  // both ways: vertices of an edge -> its triangle
  Index shared_ = 0;
};

}  // namespace

Index share_hanging_points(std::span<const Vec3> points, double reach, std::vector<Tri>& triangles,
                           std::vector<Index>& group) {
  return Zip(points, reach, triangles, group).run();
}

}  // namespace lpq

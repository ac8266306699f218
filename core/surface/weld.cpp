#include "surface/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"
#include "surface/edges.h"

namespace lpq {
namespace {

std::vector<Index> used_points(std::span<const char> used) {
  std::vector<Index> list;
  for (Index v = 0; v < static_cast<Index>(used.size()); ++v)
    if (used[v]) list.push_back(v);
  return list;
}

/// Powers of smaller coordinates underflow: points that differ in these alone have no distance.
double plain(double coordinate) {
  constexpr double least_coordinate = 1e-60;  // surfaces are 1e-30 across at least
  return std::abs(coordinate) < least_coordinate ? 0 : coordinate;
}

Vec3 plain(Vec3 p) { return {plain(p.x), plain(p.y), plain(p.z)}; }

template <class Body>
void unite_equal(std::span<const Vec3> points, std::vector<Index> list, const Body& body,
                 DisjointSets& sets) {
  sort_numbers(list, [&](Index i, Index j) {
    const Vec3 a = plain(points[i]), b = plain(points[j]);
    const Index of_a = body(i), of_b = body(j);
    return std::tie(a.x, a.y, a.z, of_a, i) < std::tie(b.x, b.y, b.z, of_b, j);
  });
  for (std::size_t k = 1; k < list.size(); ++k)
    if (plain(points[list[k - 1]]) == plain(points[list[k]]) && body(list[k - 1]) == body(list[k]))
      sets.unite(list[k - 1], list[k]);
}

/// Points in cells as wide as the distance: partners lie in the same cell or in one of 26 around
/// it.
class Cells {
 public:
  using Key = std::array<std::int64_t, 3>;

  Cells(std::span<const Vec3> points, std::span<const Index> list, double width) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low{infinity, infinity, infinity};
    for (const Index i : list) {
      low.x = std::min(low.x, points[i].x);
      low.y = std::min(low.y, points[i].y);
      low.z = std::min(low.z, points[i].z);
    }
    const auto cell = [width](double x) {
      return static_cast<std::int64_t>(std::floor(x / width));
    };
    for (const Index i : list) {
      const Vec3 p = points[i] - low;
      entries_.push_back({{cell(p.x), cell(p.y), cell(p.z)}, i});
    }
    sort_values(entries_);
  }

  template <class Visit>
  void for_each_pair(Visit&& visit) const {
    for (const auto& [key, i] : entries_)
      for (std::int64_t x = -1; x <= 1; ++x)
        for (std::int64_t y = -1; y <= 1; ++y)
          visit_column({key[0] + x, key[1] + y, key[2]}, i, visit);
  }

 private:
  using Entry = std::pair<Key, Index>;

  template <class Visit>
  void visit_column(Key key, Index i, Visit&& visit) const {
    const Entry first{{key[0], key[1], key[2] - 1}, 0};
    auto at = std::lower_bound(entries_.begin(), entries_.end(), first);
    for (; at != entries_.end() && at->first[0] == key[0] && at->first[1] == key[1] &&
           at->first[2] <= key[2] + 1;
         ++at)
      if (at->second < i) visit(at->second, i);
  }

  std::vector<Entry> entries_;
};

}  // namespace

std::vector<Index> weld_points(std::span<const Vec3> points, std::span<const char> used,
                               double distance, std::span<const Index> body) {
  DisjointSets sets(static_cast<Index>(points.size()));
  const auto body_of = [body](Index v) { return body.empty() ? 0 : body[v]; };
  unite_equal(points, used_points(used), body_of, sets);
  if (distance > 0) {
    // Equal points are one already, so that a cell does not hold many of them.
    std::vector<Index> list = used_points(used);
    std::erase_if(list, [&](Index v) { return sets.root(v) != v; });
    Cells(points, list, distance).for_each_pair([&](Index i, Index j) {
      if (body_of(i) == body_of(j) && squared_length(points[i] - points[j]) <= distance * distance)
        sets.unite(i, j);
    });
  }
  std::vector<Index> first(points.size());
  for (Index v = 0; v < static_cast<Index>(points.size()); ++v) first[v] = sets.root(v);
  return first;
}

OpenEdges open_edges(std::vector<Tri> triangles, std::span<const Index> first) {
  OpenEdges open;
  for (Tri& t : triangles)
    for (Index& v : t) v = first[v];
  open.collapsed = static_cast<Index>(std::erase_if(
      triangles, [](const Tri& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }));
  const SurfaceEdges edges = surface_edges(triangles, static_cast<Index>(first.size()));
  for (Index e = 0; e < edges.count(); ++e) open.count += edges.half_edges.row(e).size() == 1;
  return open;
}

}  // namespace lpq

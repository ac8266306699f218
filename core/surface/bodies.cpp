// See bodies.h.
#include "surface/bodies.h"

#include <algorithm>
#include <array>

#include "base/disjoint_sets.h"
#include "base/sort_numbers.h"
#include "surface/weld.h"

namespace lpq {
namespace {

void join_by_points(const SurfaceSoup& soup, DisjointSets& bodies) {
  std::vector<Index> body_at(soup.points.size(), none);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (const Index v : soup.triangles[t]) {
      if (body_at[v] == none) body_at[v] = soup.body[t];
      bodies.unite(body_at[v], soup.body[t]);
    }
}

/// #bodies; by the root of each.
std::vector<char> open_bodies(const SurfaceSoup& soup, DisjointSets& bodies) {
  const std::vector<char> used(soup.points.size(), 1);
  const std::vector<Index> first = weld_points(soup.points, used, 0);
  std::vector<std::array<Index, 3>> sides;  // body, ends
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = first[soup.triangles[t][k]], b = first[soup.triangles[t][(k + 1) % 3]];
      if (a != b) sides.push_back({bodies.root(soup.body[t]), std::min(a, b), std::max(a, b)});
    }
  sort_values(sides);
  std::vector<char> open(soup.body_names.size(), 0);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end] == sides[i];) ++end;
    if (end == i + 1) open[sides[i][0]] = 1;
  }
  return open;
}

}  // namespace

void join_loose_bodies(SurfaceSoup& soup) {
  const auto count = static_cast<Index>(soup.body_names.size());
  DisjointSets bodies(count);
  join_by_points(soup, bodies);
  const std::vector<char> open = open_bodies(soup, bodies);
  const auto sheet = std::find(open.begin(), open.end(), 1) - open.begin();
  for (Index b = 0; b < count; ++b)
    if (open[b]) bodies.unite(static_cast<Index>(sheet), b);
  std::vector<Index> number(count, none);
  std::vector<std::string> names;
  for (Index& body : soup.body) {
    const Index root = bodies.root(body);
    if (number[root] == none) {
      number[root] = static_cast<Index>(names.size());
      names.push_back(soup.body_names[root]);
    }
    body = number[root];
  }
  soup.body_names = std::move(names);
}

}  // namespace lpq

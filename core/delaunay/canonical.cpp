// A normal form of triangulations: every triangle starts at its smallest vertex, and triangles are
// sorted by their corners. Two meshes with the same triangles, regions and walls become equal.
#include <algorithm>
#include <numeric>

#include "delaunay/delaunay.h"

namespace lpq {

TriMesh canonical(TriMesh mesh) {
  const Index count = mesh.triangle_count();
  std::vector<Index> first(count);  // corner that becomes the first
  std::vector<Tri> turned(count);
  for (Index t = 0; t < count; ++t) {
    const Tri& c = mesh.triangles[t];
    first[t] = static_cast<Index>(std::min_element(c.begin(), c.end()) - c.begin());
    for (Index k = 0; k < 3; ++k) turned[t][k] = c[(first[t] + k) % 3];
  }
  std::vector<Index> order(count), rank(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index s, Index t) {
    return turned[s] != turned[t] ? turned[s] < turned[t] : s < t;
  });
  for (Index i = 0; i < count; ++i) rank[order[i]] = i;

  TriMesh result;
  result.fixed = mesh.fixed;
  result.points = std::move(mesh.points);
  for (const Index t : order) {
    result.triangles.push_back(turned[t]);
    result.region.push_back(mesh.region[t]);
    for (Index k = 0; k < 3; ++k) {
      const Index f = mesh.twins[3 * t + (first[t] + k) % 3];
      const Index s = f / 3;
      result.twins.push_back(f == none ? none : 3 * rank[s] + (f % 3 - first[s] + 3) % 3);
    }
  }
  return result;
}

}  // namespace lpq

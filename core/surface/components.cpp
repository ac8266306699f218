#include "surface/components.h"

namespace lpq {

Components components_of(std::span<const Index> twins, std::span<const char> barrier) {
  Components result;
  const Index triangles = static_cast<Index>(twins.size() / 3);
  result.of_triangle.assign(triangles, none);
  std::vector<Index> stack;
  for (Index seed = 0; seed < triangles; ++seed) {
    if (result.of_triangle[seed] != none) continue;
    result.of_triangle[seed] = result.count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (Index e = 3 * t; e < 3 * t + 3; ++e) {
        const Index twin = twins[e];
        if (twin == none || (!barrier.empty() && (barrier[e] || barrier[twin]))) continue;
        Index& slot = result.of_triangle[triangle_of(twin)];
        if (slot != none) continue;
        slot = result.count;
        stack.push_back(triangle_of(twin));
      }
    }
    ++result.count;
  }
  return result;
}

}  // namespace lpq

// See sides.h.
#include "shell/sides.h"

#include <algorithm>
#include <tuple>

#include "base/sort_numbers.h"

namespace lpq {

std::vector<FaceSide> sides_by_edge(std::span<const Face> faces) {
  std::vector<FaceSide> sides;
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f)
    for (int k = 0, n = corner_count(faces[f]); k < n; ++k) {
      const Index a = faces[f][k], b = faces[f][(k + 1) % n];
      sides.push_back({{std::min(a, b), std::max(a, b)}, a < b, f, k});
    }
  sort_values(sides, [](const FaceSide& s, const FaceSide& t) {
    return std::tie(s.ends, s.face, s.corner) < std::tie(t.ends, t.face, t.corner);
  });
  return sides;
}

}  // namespace lpq

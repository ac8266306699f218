#include "surface/charts/part.h"

#include <algorithm>
#include <utility>

#include "surface/fans.h"

namespace lpq {
namespace {

Index next_on_border(const Part& part, Index e) {
  Index next = next_in_triangle(e);
  while (part.twins[next] != none) next = next_in_triangle(part.twins[next]);
  return next;
}

void find_loops(Part& part) {
  std::vector<std::vector<Index>> loops;
  std::vector<char> seen(part.twins.size(), 0);
  for (Index e = 0; e < static_cast<Index>(part.twins.size()); ++e) {
    if (part.twins[e] != none || seen[e]) continue;
    loops.emplace_back();
    for (Index f = e; !seen[f]; f = next_on_border(part, f)) {
      seen[f] = 1;
      loops.back().push_back(f);
    }
  }
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    double sum = 0;
    for (const Index e : loops[i]) sum += part.length[e];
    if (sum > most) most = sum, longest = i;
  }
  if (!loops.empty()) std::swap(loops[0], loops[longest]);
  for (const auto& loop : loops) {
    part.loops.values.insert(part.loops.values.end(), loop.begin(), loop.end());
    part.loops.end_row();
  }
}

}  // namespace

Part PartTaker::take(std::vector<Index> triangles, std::span<const char> cut) {
  Part part;
  part.triangles = std::move(triangles);
  std::sort(part.triangles.begin(), part.triangles.end());
  const Index count = part.triangle_count();
  for (Index t = 0; t < count; ++t) own_[part.triangles[t]] = t;
  part.twins.reserve(3 * static_cast<std::size_t>(count));
  part.length.reserve(3 * static_cast<std::size_t>(count));
  for (Index e = 0; e < 3 * count; ++e) {
    const Index there = part.on_surface(e), twin = mesh_.twins[there];
    const Index other = twin == none || cut[there] ? none : own_[triangle_of(twin)];
    part.twins.push_back(other == none ? none : 3 * other + twin % 3);
    part.length.push_back(
        distance(mesh_.points[mesh_.origin(there)], mesh_.points[mesh_.target(there)]));
  }
  for (const Index t : part.triangles) own_[t] = none;

  const SurfaceFans fans = fans_of(part.twins);
  for (Index f = 0; f < fans.count(); ++f)
    part.vertex.push_back(mesh_.origin(part.on_surface(fans.corners.row(f)[0])));
  part.corners.resize(count);
  for (Index t = 0; t < count; ++t)
    for (Index k = 0; k < 3; ++k) part.corners[t][k] = fans.of_corner[3 * t + k];
  find_loops(part);
  return part;
}

double loop_length(const Part& part, Index loop) {
  double sum = 0;
  for (const Index e : part.loops.row(loop)) sum += part.length[e];
  return sum;
}

}  // namespace lpq

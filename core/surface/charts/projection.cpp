#include "surface/charts/projection.h"

#include <algorithm>
#include <cmath>

#include "surface/charts/checks.h"

namespace lpq {
namespace {

constexpr double most_height = 1e-3, least_gap = 1e-9;

Index longest_edge(const Part& part) {
  const auto longer = [&](Index e, Index f) { return part.length[e] < part.length[f]; };
  const std::span<const Index> loop = part.loops.row(0);
  return *std::max_element(loop.begin(), loop.end(), longer);
}

}  // namespace

bool map_projection(const SurfaceMesh& mesh, const Part& part, std::vector<Vec2>& uv) {
  const auto at = [&](Index v) { return mesh.points[part.vertex[v]]; };
  const Index first = longest_edge(part);
  const Vec3 origin = at(part.origin(first));
  Vec3 normal;
  for (const auto& [a, b, c] : part.corners) normal += cross(at(b) - at(a), at(c) - at(a));
  const Vec3 edge = at(part.target(first)) - origin, side = cross(normal, edge);
  const double height = length(normal), width = length(side);
  if (!(height > 0) || !(width > 0)) return false;
  normal = (1 / height) * normal;
  const Vec3 y = (1 / width) * side, x = cross(y, normal);
  double low = 0, high = 0, reach = 0;
  uv.clear();
  for (Index v = 0; v < part.vertex_count(); ++v) {
    const Vec3 p = at(v) - origin;
    uv.push_back({dot(p, x), dot(p, y)});
    low = std::min(low, dot(p, normal));
    high = std::max(high, dot(p, normal));
    reach = std::max(reach, std::max(std::fabs(uv.back().x), std::fabs(uv.back().y)));
  }
  // Nothing is far smaller than the part: what is zero but for rounding comes out as zero.
  const double base = 4 * reach;
  for (Vec2& p : uv) p = {(p.x + base) - base, (p.y + base) - base};
  return high - low <= most_height * reach && !borders_touch(part, uv, least_gap * reach);
}

}  // namespace lpq

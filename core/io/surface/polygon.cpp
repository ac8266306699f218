// See polygon.h.
#include "io/surface/polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/predicates.h"

namespace lpq {
namespace {

constexpr std::size_t most_apexes = 64, most_with_ears = 4096;

/// Twice the area of a polygon as a vector (Newell), from its first corner.
Vec3 area_vector(std::span<const Index> corners, const std::vector<Vec3>& points) {
  const Vec3 origin = points[corners[0]];
  Vec3 sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += cross(points[corners[k]] - origin, points[corners[k + 1]] - origin);
  return sum;
}

bool sees_whole_polygon(std::span<const Index> corners, const std::vector<Vec3>& points,
                        std::size_t apex, Vec3 area) {
  const std::size_t n = corners.size();
  const Vec3 origin = points[corners[apex]];
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Vec3 a = points[corners[(apex + k) % n]], b = points[corners[(apex + k + 1) % n]];
    if (!(dot(cross(a - origin, b - origin), area) > 0)) return false;
  }
  return true;
}

std::vector<Tri> fan(std::span<const Index> corners, std::size_t apex) {
  std::vector<Tri> triangles;
  const std::size_t n = corners.size();
  for (std::size_t k = 1; k + 1 < n; ++k)
    triangles.push_back({corners[apex], corners[(apex + k) % n], corners[(apex + k + 1) % n]});
  return triangles;
}

/// Along the axis that the area looks along most, so that a flat polygon has no double points there
/// and turns left.
std::vector<Vec2> seen_along(Vec3 area, std::span<const Index> corners,
                             const std::vector<Vec3>& points) {
  const double x = std::abs(area.x), y = std::abs(area.y), z = std::abs(area.z);
  std::vector<Vec2> seen;
  for (const Index v : corners) {
    const Vec3 p = points[v];
    if (z >= x && z >= y)
      seen.push_back(area.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x});
    else if (x >= y)
      seen.push_back(area.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y});
    else
      seen.push_back(area.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z});
  }
  return seen;
}

/// Cuts corners off a ring of them.
class EarCutter {
 public:
  EarCutter(std::span<const Index> corners, std::vector<Vec2> seen)
      : corners_(corners), seen_(std::move(seen)) {
    for (std::size_t i = 0; i < corners.size(); ++i) ring_.push_back(static_cast<Index>(i));
    if (ring_.size() > most_with_ears) return;
    for (std::size_t k = 0; k < ring_.size(); ++k) worth_.push_back(worth(k));
  }

  DividedPolygon run() {
    while (ring_.size() > 3 && ring_.size() <= most_with_ears) {
      const std::size_t best = std::max_element(worth_.begin(), worth_.end()) - worth_.begin();
      if (!(worth_[best] > 0)) break;
      cut(best);
    }
    for (const auto& [a, b, c] : fan(ring_, 0)) {
      result_.triangles.push_back({corners_[a], corners_[b], corners_[c]});
      result_.turned = result_.turned || orient2d(seen_[a], seen_[b], seen_[c]) < 0;
    }
    return std::move(result_);
  }

 private:
  std::size_t before(std::size_t k) const { return k == 0 ? ring_.size() - 1 : k - 1; }
  std::size_t after(std::size_t k) const { return k + 1 == ring_.size() ? 0 : k + 1; }

  void cut(std::size_t k) {
    result_.triangles.push_back(
        {corners_[ring_[before(k)]], corners_[ring_[k]], corners_[ring_[after(k)]]});
    ring_.erase(ring_.begin() + k);
    worth_.erase(worth_.begin() + k);
    const std::size_t next = k == ring_.size() ? 0 : k;
    worth_[next] = worth(next);
    worth_[before(next)] = worth(before(next));
  }

  /// How well shaped the ear at this corner is; 0 if it is none.
  double worth(std::size_t k) const {
    const Vec2 a = seen_[ring_[before(k)]], b = seen_[ring_[k]], c = seen_[ring_[after(k)]];
    if (!(orient2d(a, b, c) > 0)) return 0;
    for (const Index i : ring_) {
      const Vec2 p = seen_[i];
      if (p == a || p == b || p == c) continue;  // a bridge to a hole passes its ends twice
      if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) return 0;
    }
    return cross(b - a, c - a) /
           (squared_length(b - a) + squared_length(c - b) + squared_length(a - c));
  }

  std::span<const Index> corners_;
  std::vector<Vec2> seen_;     // of each corner
  std::vector<Index> ring_;    // corners left
  std::vector<double> worth_;  // of each in the ring
  DividedPolygon result_;
};

}  // namespace

DividedPolygon divide_polygon(std::span<const Index> corners, const std::vector<Vec3>& points) {
  if (corners.size() == 3) return {fan(corners, 0), false};
  const Vec3 area = area_vector(corners, points);
  const std::size_t apexes = std::min(corners.size(), most_apexes);
  for (std::size_t apex = 0; apex < apexes; ++apex)
    if (sees_whole_polygon(corners, points, apex, area)) return {fan(corners, apex), false};
  return EarCutter(corners, seen_along(area, corners, points)).run();
}

}  // namespace lpq

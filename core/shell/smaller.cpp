// See smaller.h.
#include "shell/smaller.h"

#include <algorithm>

#include "base/sort_numbers.h"
#include "shell/place.h"
#include "surface/size_field.h"

namespace lpq {
namespace {

constexpr double smaller = 0.6;
constexpr double reach = 1.5;  // mesh sizes around a fault

/// Finds vertices near a point among those with x nearly the same.
class VerticesByX {
 public:
  explicit VerticesByX(std::span<const Vec3> points)
      : points_(points), order_(sorted_numbers(points.size(), [&](Index a, Index b) {
          return points[a].x != points[b].x ? points[a].x < points[b].x : a < b;
        })) {}

  template <class Visit>
  void for_each_near(Vec3 centre, double radius, Visit&& visit) const {
    const auto before = [&](Index v, double x) { return points_[v].x < x; };
    auto at = std::lower_bound(order_.begin(), order_.end(), centre.x - radius, before);
    for (; at != order_.end() && points_[*at].x <= centre.x + radius; ++at)
      if (distance(points_[*at], centre) < radius) visit(*at);
  }

 private:
  std::span<const Vec3> points_;
  std::vector<Index> order_;
};

}  // namespace

bool make_smaller(const SurfaceMesh& mesh, std::span<const Fault> faults, bool widely,
                  double growth, std::span<double> size) {
  const VerticesByX vertices(mesh.points);
  std::vector<char> meant(size.size(), 0);
  for (const Fault& fault : faults) {
    if (fault.place.triangle == none || widely)
      for (const Index v : fault.everywhere) meant[v] = 1;
    if (fault.place.triangle == none) continue;
    for (const Index v : mesh.triangles[fault.place.triangle]) meant[v] = 1;
    const Vec3 centre = point_at(mesh, fault.place);
    const double radius = reach * size_at(mesh.triangles, fault.place, size);
    vertices.for_each_near(centre, radius, [&](Index v) { meant[v] = 1; });
  }
  if (std::count(meant.begin(), meant.end(), 1) == 0) return false;
  for (std::size_t v = 0; v < meant.size(); ++v)
    if (meant[v]) size[v] *= smaller;
  limit_surface_growth(mesh, growth, size);
  return true;
}

}  // namespace lpq

// See smaller.h.
#include "shell/smaller.h"

#include <algorithm>

#include "shell/place.h"
#include "surface/size_field.h"

namespace lpq {
namespace {

constexpr double smaller = 0.6;
constexpr double reach = 1.5;  // mesh sizes around a fault

}  // namespace

bool make_smaller(const SurfaceMesh& mesh, std::span<const Fault> faults, bool widely,
                  double growth, std::span<double> size) {
  std::vector<char> meant(size.size(), 0);
  for (const Fault& fault : faults) {
    if (fault.place.triangle == none || widely)
      for (const Index v : fault.everywhere) meant[v] = 1;
    if (fault.place.triangle == none) continue;
    for (const Index v : mesh.triangles[fault.place.triangle]) meant[v] = 1;
    const Vec3 centre = point_at(mesh, fault.place);
    const double radius = reach * size_at(mesh.triangles, fault.place, size);
    for (std::size_t v = 0; v < meant.size(); ++v)
      if (distance(mesh.points[v], centre) < radius) meant[v] = 1;
  }
  if (std::count(meant.begin(), meant.end(), 1) == 0) return false;
  for (std::size_t v = 0; v < meant.size(); ++v)
    if (meant[v]) size[v] *= smaller;
  limit_surface_growth(mesh, growth, size);
  return true;
}

}  // namespace lpq
